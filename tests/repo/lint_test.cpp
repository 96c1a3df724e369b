// SPDX-License-Identifier: MIT
// The project follows its rules, and each rule finds a sample that breaks it.
#include "repo/lint.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "common/home.h"

namespace strobe::repo {
namespace lint_test {

const std::vector<Source>& project() {
  static const std::vector<Source> sources = readSources(home().shipped());
  return sources;
}

Floors floors() { return parseFloors(readText(home().shipped() / "runtime/floors.txt")); }

std::string joined(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

TEST(Project, IsRead) {
  EXPECT_GT(project().size(), 50u);
  auto has = [](const std::string& path) {
    return std::any_of(project().begin(), project().end(), [&](const Source& source) { return source.path == path; });
  };
  for (const char* path : {"strobe", ".ci/run", "CMakeLists.txt", "runtime/base/error.h", "tests/repo/lint_test.cpp"}) {
    EXPECT_TRUE(has(path)) << path;
  }
}

TEST(Project, EveryFolderHasAFloor) {
  Floors known = floors();
  for (const auto& entry : std::filesystem::directory_iterator(home().shipped() / "runtime")) {
    if (entry.is_directory()) EXPECT_TRUE(known.count(entry.path().filename().string())) << entry.path();
  }
}

TEST(Project, IncludesFollowTheFloors) { EXPECT_EQ(joined(lintFloors(project(), floors())), ""); }
TEST(Project, HomeIsPassedAsAnArgument) { EXPECT_EQ(joined(lintHome(project())), ""); }
TEST(Project, ForeignHeadersStayInTheirFolders) { EXPECT_EQ(joined(lintForeignHeaders(project())), ""); }
TEST(Project, ShadersListTheirNeeds) { EXPECT_EQ(joined(lintMixins(project())), ""); }
TEST(Project, ClassesAreSmall) { EXPECT_EQ(joined(lintClasses(project(), 30)), ""); }
TEST(Project, EverySourceStatesItsLicence) { EXPECT_EQ(joined(lintLicences(project())), ""); }
TEST(Project, NoTextNamesAMachine) { EXPECT_EQ(joined(lintMachines(project())), ""); }

// A rule that never finds anything would pass on any project.
TEST(Lint, EachRuleFindsASample) {
  const Floors floors = parseFloors("# comment\n0 base\n1 math\n2 plan not math\n");
  const std::string vulkan = "#include <vulkan/vulkan.h>\n";
  const Source mixin{"shaders/mixin/b.glsl", "// x\n// Needs: nothing.\na_tex;\n#if HAS_b\nb_tex;\n#endif\n"};
  const std::pair<Findings, const char*> samples[] = {
      {lintFloors({{"runtime/base/a.h", "\n#include \"math/b.h\"\n"}}, floors),
       "runtime/base/a.h:2: 'math/b.h' is not on a lower floor"},
      {lintFloors({{"runtime/plan/a.h", "#include \"math/b.h\"\n"}}, floors), "plan may not know math"},
      {lintFloors({{"runtime/plan/a.h", "#include \"b.h\"\n"}}, floors), "'b.h' does not say its folder"},
      {lintFloors({{"runtime/cellar/a.h", ""}}, floors), "is on no floor"},
      {lintFloors({{"shaders/edge/a.glsl", "#include \"tile/a.glsl\"\n"}}, {}), "of another family"},
      {lintHome({{"runtime/a/b.cpp",
                  "set"
                  "env(\"A\", \"b\", 1);\n"}}),
       "changes the environment"},
      {lintHome({{"runtime/a/b.cpp",
                  "Home::from"
                  "Environment();\n"}}),
       "makes a home instead of taking one"},
      {lintForeignHeaders({{"runtime/plan/a.h", vulkan}}), "runtime/plan/a.h:1"},
      {lintMixins({{"shaders/lib/a.glsl", "float f() { return params.b; }\n"}}), "is not a pure function"},
      {lintMixins({mixin}), "'// Needs: a_tex; may have: b_tex.'"},
      {lintClasses({{"runtime/a/b.h", "class A {\n  A();\n  void b() const;\n  void (*c)(int);\n};\n"}}, 1),
       "A has 2 methods"},
      {lintLicences({{"a.lua", ""}}), "a.lua"},
      {lintMachines({{"docs/a.md",
                      "see /ro"
                      "ot/somebody/x"}}),
       "docs/a.md:1"},
  };
  for (const auto& [findings, wanted] : samples) {
    EXPECT_EQ(findings.size(), 1u) << wanted << "\n" << joined(findings);
    EXPECT_NE(joined(findings).find(wanted), std::string::npos) << joined(findings);
  }
  EXPECT_THROW(parseFloors("0 base\n1 base\n"), Error);
}

}  // namespace lint_test
}  // namespace strobe::repo
