// SPDX-License-Identifier: MIT
// Lua requires follow their floors, C++ knows no technique; and each rule finds a sample that breaks it.
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

TEST(LuaProject, WhatIsReadPointwiseIsLookedUpSo) { EXPECT_EQ(joined(lintPointwise(project())), ""); }

TEST(LuaLint, FindsWhatIsNotReadPointwise) {
  const Source pass{"passes/a.lua",
                    "shader = \"list/a\",\n  seen = { pointwise = true, doc = \"x\" },\n  hit = { uint = true },\n"};
  const Source mixin{"shaders/mixin/b.glsl", "vec4 b = texelFetch(seen_tex, at, 0);\n"};
  auto lint = [&](const char* text) { return joined(lintPointwise({pass, {"shaders/list/a.glsl", text}, mixin})); };
  EXPECT_EQ(lint("vec4 a = texelFetch(seen_tex, pixel, 0) + texelFetch(hit_tex, at, 0);\n"), "");
  EXPECT_EQ(lint("\nvec4 a = texelFetch(seen_tex, pixel, 0) + texelFetch(seen_tex, at, 0);\n"),
            "shaders/list/a.glsl:2: 'seen' is read pointwise\n");
  EXPECT_EQ(lint("#include \"mixin/b.glsl\"\n"), "shaders/mixin/b.glsl:1: 'seen' is read pointwise\n");
  EXPECT_EQ(lint("vec4 a = texelFetch(unseen_tex, at, 0);\n"), "");
  EXPECT_EQ(lint("vec4 a = seen_at(pixel) + hit_at(other);\n"), "");
  EXPECT_EQ(lint("vec4 a = seen_at(other);\n"), "shaders/list/a.glsl:1: 'seen' is read pointwise\n");
  const Source named_by_path{"passes/list/a.lua", "reads = { seen = { pointwise = true, doc = \"x\" } }\n"};
  EXPECT_EQ(joined(lintPointwise({named_by_path, {"shaders/list/a.glsl", "vec4 a = seen_at(other);\n"}})),
            "shaders/list/a.glsl:1: 'seen' is read pointwise\n");
}

TEST(LuaLint, FindsRequiresOfAFloorAbove) {
  Floors floors =
      parseFloors("0 scripts/strobe\n1 passes/lib\n2 passes\n2 scripts/scenes not passes/lib\n3 scripts/pipelines\n");
  auto lint = [&](const char* path, const char* text) { return joined(lintRequires({{path, text}}, floors)); };
  EXPECT_EQ(lint("passes/edge/a.lua", "local a = require \"strobe.pass\"\nlocal b = require(\"passes.lib.b\")\n"), "");
  EXPECT_EQ(lint("passes/edge/a.lua", "local b = require \"passes.tile.b\" -- require \"scripts.x\"\n"), "");
  EXPECT_EQ(lint("passes/lib/a.lua", "\nlocal b = require 'passes.tile.b'\n"),
            "passes/lib/a.lua:2: 'passes.tile.b' is not on a lower floor\n");
  EXPECT_EQ(lint("passes/edge/a.lua", "local b = require \"scripts.pipelines.lib.b\"\n"),
            "passes/edge/a.lua:1: 'scripts.pipelines.lib.b' is not on a lower floor\n");
  EXPECT_EQ(lint("scripts/scenes/a.lua", "local b = require \"passes.lib.b\"\n"),
            "scripts/scenes/a.lua:1: scripts/scenes may not know passes/lib ('passes.lib.b')\n");
  EXPECT_EQ(lint("passes/a.lua", "local b = require \"cellar.b\"\n"), "passes/a.lua:1: 'cellar.b' is in no room\n");
  EXPECT_EQ(lint("cellar/a.lua", ""), "cellar/a.lua:1: is in no room\n");
}

const std::vector<Source> kDeclared = {
    {"passes/edge/sobel.lua",
     "return pass.compute {\n  name   = \"edge_sobel\",\n  params = {\n    big_step = pass.int { 1 },\n"},
    {"passes/gather/mean1999.lua", "  shift = other.params.shift,\n"},
    {"passes/lib/blur.lua", "  reach = param.float { 1 },\n"},
    {"scripts/pipelines/stop.lua", "    samples = int { 1 },\n"}};

TEST(LuaLint, TakesNamesFromDeclarations) {
  TechniqueNames found = techniqueNames(kDeclared);
  EXPECT_EQ(found.names, (std::set<std::string>{"edge_sobel", "mean", "mean1999", "sobel", "stop"}));
  EXPECT_EQ(found.parameters, (std::set<std::string>{"big_step", "reach", "samples", "shift"}));
}

TEST(LuaLint, FindsTechniquesInCpp) {
  TechniqueNames names = techniqueNames(kDeclared);
  KnownWords known = parseKnownWords("# comment\nquoted stop: a word\nquoted mean: a word\nfree shift: a word\n");
  auto count = [&](const char* text) { return lintTechniques({{"runtime/a/a.cpp", text}}, names, known).size(); };
  for (const char* text : {"int SobelEdge;", "// as sobel does", "edgeSobel();", "kEdge_sobel", "x == \"stop\"",
                           "\"samples\"", "\"big_step\"", "// Mean1999"})
    EXPECT_GE(count(text), 1u) << text;
  for (const char* text : {"stop(); // samples, the mean", "\"shift\"", "int soberly;", "\"stop it\""})
    EXPECT_EQ(count(text), 0u) << text;
  EXPECT_TRUE(lintTechniques({{"shaders/a.glsl", "// sobel"}}, names, known).empty());
}

TEST(LuaLint, ExceptionsAreForOnePlaceAndMustBeNeeded) {
  TechniqueNames names = techniqueNames(kDeclared);
  KnownWords known =
      parseKnownWords("at runtime/a/a.cpp samples: a field of its own\nquoted stop: x\nquoted mean: x\n");
  EXPECT_EQ(joined(lintTechniques({{"runtime/a/a.cpp", "\"samples\""}}, names, known)), "");
  EXPECT_EQ(joined(lintTechniques({{"runtime/a/b.cpp", "\"samples\""}}, names, known)),
            "runtime/a/b.cpp:1: names a technique: 'samples'\n");
  EXPECT_EQ(joined(lintTechniques({{"runtime/a/a.cpp", "samples"}}, names, known)),
            "runtime/a/a.cpp does not name 'samples' any more\n");
  known = parseKnownWords("quoted stop: x\nquoted mean: x\nquoted gone: x\n");
  EXPECT_EQ(joined(lintTechniques({}, names, known)), "'gone' is known, but no technique has that name\n");
  EXPECT_THROW(parseKnownWords("quoted stop\n"), Error);
  EXPECT_THROW(parseKnownWords("stop: x\n"), Error);
}

}  // namespace lua_lint_test
}  // namespace strobe::repo
