// SPDX-License-Identifier: MIT
// Lua requires follow their floors, C++ names no technique, and each rule finds a sample that breaks it.
#include "repo/lua_lint.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "common/source.h"

namespace strobe::repo {
namespace lua_lint_test {

const std::vector<Source>& project() {
  static const std::vector<Source> sources = readSources(sourceFolder());
  return sources;
}

std::string joined(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

TEST(LuaProject, RequiresFollowTheFloors) {
  EXPECT_EQ(joined(lintRequires(project(), parseFloors(readText(sourceFolder() / "scripts/floors.txt")))), "");
}

TEST(LuaProject, CppNamesNoTechnique) {
  TechniqueNames techniques = techniqueNames(project());
  for (const char* name : {"sobel", "tile_max", "hybrid", "mcguire", "mcguire2012"})
    EXPECT_TRUE(techniques.names.count(name)) << name;
  for (const char* name : {"tile", "samples", "limit", "mask_taps", "termination", "normal_threshold"})
    EXPECT_TRUE(techniques.parameters.count(name)) << name;
  KnownWords known = parseKnownWords(readText(sourceFolder() / "tests/repo/techniques.txt"));
  EXPECT_EQ(joined(lintTechniques(project(), techniques, known)), "");
}

TEST(LuaProject, PointwiseReadsAreFetchedPointwise) { EXPECT_EQ(joined(lintPointwise(project())), ""); }

// A rule that never finds anything would pass on any project.
TEST(LuaLint, EachRuleFindsASample) {
  const Source pass{"passes/list/a.lua", "reads = { seen = { pointwise = true, doc = \"x\" } }\n"};
  EXPECT_EQ(joined(lintPointwise({pass, {"shaders/list/a.glsl", "seen_at(pixel);\nvec4 a = seen_at(other);\n"}})),
            "shaders/list/a.glsl:2: 'seen' is read pointwise\n");
  Floors floors = parseFloors("0 passes/lib\n1 passes\n1 scripts/scenes not passes/lib\n");
  EXPECT_EQ(joined(lintRequires({{"passes/lib/a.lua", "\nlocal b = require 'passes.tile.b'\n"},
                                 {"scripts/scenes/a.lua", "local b = require \"passes.lib.b\"\n"}},
                                floors)),
            "passes/lib/a.lua:2: 'passes.tile.b' is not on a lower floor\n"
            "scripts/scenes/a.lua:1: scripts/scenes may not know passes/lib ('passes.lib.b')\n");
  TechniqueNames names = techniqueNames({{"passes/edge/sobel.lua", "  params = {\n    big_step = pass.int { 1 },\n"}});
  EXPECT_EQ(joined(lintTechniques({{"runtime/a/a.cpp", "edgeSobel(\"big_step\");"}}, names, {})),
            "runtime/a/a.cpp:1: names a technique: 'big_step'\nruntime/a/a.cpp:1: names a technique: 'sobel'\n");
}

}  // namespace lua_lint_test
}  // namespace strobe::repo
