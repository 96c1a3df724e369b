// SPDX-License-Identifier: MIT
// The rules of the house hold in the project; and each rule finds a sample that breaks it.
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

TEST(Project, EveryRoomHasAFloor) {
  Floors known = floors();
  for (const auto& entry : std::filesystem::directory_iterator(home().shipped() / "runtime")) {
    if (entry.is_directory()) EXPECT_TRUE(known.count(entry.path().filename().string())) << entry.path();
  }
}

TEST(Project, IncludesFollowTheFloors) { EXPECT_EQ(joined(lintFloors(project(), floors())), ""); }
TEST(Project, TheHomeIsPassedOn) { EXPECT_EQ(joined(lintHome(project())), ""); }
TEST(Project, ForeignHeadersStayInTheirRooms) { EXPECT_EQ(joined(lintForeignHeaders(project())), ""); }
TEST(Project, ShadersSayWhatTheyNeed) { EXPECT_EQ(joined(lintMixins(project())), ""); }
TEST(Project, ClassesAreSmall) { EXPECT_EQ(joined(lintClasses(project(), 30)), ""); }
TEST(Project, EverySourceSaysItsLicence) { EXPECT_EQ(joined(lintLicences(project())), ""); }
TEST(Project, NothingBelongsToAMachine) { EXPECT_EQ(joined(lintMachines(project())), ""); }

TEST(Lint, CountsTheMethodsOfAClass) {
  std::string text = R"(class A : public B {
 public:
  A();  // one()
  ~A() { destroy(); }
  bool operator==(const A&) const = default;
  static std::vector<int> list(const std::function<void(int)>& each = {});

 private:
  struct Nested {
    void notCounted();
  };
  using Call = void (*)(int);
  friend void other(A&);
  int number_ = f(3);
  std::function<void(int)> call_;
  std::map<int, std::vector<int>> map_{{1, {}}};
};
)";
  EXPECT_EQ(joined(lintClasses({{"runtime/a/b.h", text}}, 4)), "");
  EXPECT_EQ(joined(lintClasses({{"runtime/a/b.h", text}}, 3)),
            "runtime/a/b.h:1: A has 4 methods, at most 3 may it have\n");
  EXPECT_EQ(joined(lintClasses({{"runtime/a/b.cpp", text}}, 3)), "");
}

TEST(Lint, FindsAHomeThatIsLookedUpOrSet) {
  auto lint = [](const char* path, const std::string& text) { return joined(lintHome({{path, text}})); };
  EXPECT_EQ(lint("runtime/a/b.cpp",
                 "int x;\n::set"
                 "env(\"A\", \"b\", 1);\n"),
            "runtime/a/b.cpp:2: changes the environment of this process\n");
  std::string asks =
      "auto h = Home::from"
      "Environment();\n";
  EXPECT_EQ(lint("runtime/lab/a.cpp", asks), "runtime/lab/a.cpp:1: makes a home instead of taking one\n");
  EXPECT_EQ(lint("runtime/app/main.cpp", asks) + lint("tests/a/b.cpp", asks), "");
}

TEST(Lint, FindsIncludesOfAFloorAbove) {
  Floors three = parseFloors("# comment\n0 base\n1 math\n1 image\n2 plan not image\n");
  auto lint = [&](const char* path, const char* text) { return joined(lintFloors({{path, text}}, three)); };
  EXPECT_EQ(lint("runtime/math/a.h", "#include <vector>\n#include \"base/b.h\"\n#include \"math/c.h\"\n"), "");
  EXPECT_EQ(lint("runtime/base/a.h", "// x\n#include \"math/b.h\"\n"),
            "runtime/base/a.h:2: 'math/b.h' is not on a lower floor\n");
  EXPECT_EQ(lint("runtime/math/a.cpp", "  # include \"image/b.h\"\n"),
            "runtime/math/a.cpp:1: 'image/b.h' is not on a lower floor\n");
  EXPECT_EQ(lint("runtime/plan/a.cpp", "#include \"image/b.h\"\n"),
            "runtime/plan/a.cpp:1: plan may not know image ('image/b.h')\n");
  EXPECT_EQ(lint("runtime/plan/a.cpp", "#include \"b.h\"\n"), "runtime/plan/a.cpp:1: 'b.h' does not say its folder\n");
  EXPECT_EQ(lint("runtime/plan/a.cpp", "#include \"cellar/b.h\"\n"),
            "runtime/plan/a.cpp:1: 'cellar/b.h' is in no room\n");
  EXPECT_EQ(lint("runtime/cellar/a.cpp", ""), "runtime/cellar/a.cpp:1: is on no floor\n");
}

TEST(Lint, FindsIncludesOfAnotherFamily) {
  auto lint = [](const char* text) { return joined(lintFloors({{"shaders/edge/a.glsl", text}}, {})); };
  EXPECT_EQ(lint("#include \"lib/a.glsl\"\n#include \"shared/b.h\"\n#include \"edge/c.glsl\"\n"), "");
  EXPECT_EQ(lint("#include \"tile/a.glsl\"\n"), "shaders/edge/a.glsl:1: includes 'tile/a.glsl' of another family\n");
}

TEST(Lint, FindsWhatMixinsDoNotSay) {
  auto lint = [](const std::string& path, const std::string& text) {
    Source below{"shaders/mixin/below.glsl", "// x\n// Needs: a_tex.\ntexelFetch(a_tex, params_of, 0); // params.c\n"};
    return joined(lintMixins({below, {path, text}}));
  };
  EXPECT_EQ(lint("shaders/lib/a.glsl", "float f(uint n) { return float(n + frame.seed); }\n"), "");
  EXPECT_EQ(lint("shaders/lib/a.glsl", "float f() { return params.b; }\n"),
            "shaders/lib/a.glsl: is no pure function, but has '// Needs: params.b.'\n");
  EXPECT_EQ(lint("shaders/lib/a.glsl", "#include \"mixin/below.glsl\"\n").substr(0, 41),
            "shaders/lib/a.glsl: is no pure function, ");
  EXPECT_EQ(lint("shaders/mixin/a.glsl", "// x\n// Needs: nothing.\nint f;\n"),
            "shaders/mixin/a.glsl: needs nothing: belongs to lib/\n");
  EXPECT_EQ(
      lint("shaders/mixin/a.glsl", "// x\n// Needs: b_tex; may have: c_tex.\nb_at(p);\n#if HAS_c\nc_at(p);\n#endif\n"),
      "");
  EXPECT_EQ(lint("shaders/mixin/a.glsl", "// x\n// Needs: nothing; may have: b_buf.\n#if HAS_b\nb_buf.x;\n#endif\n"),
            "");
  std::string uses = "#include \"mixin/below.glsl\"\n#if HAS_b\nb_tex; count_d(1u);\n#endif\n#if PARAM_e\nscene_x[0]\n";
  EXPECT_EQ(
      lint("shaders/mixin/a.glsl", "// x\n// Needs: PARAM_e, a_tex, scene; may have: b_tex,\n//   count_d.\n" + uses),
      "");
  EXPECT_EQ(lint("shaders/mixin/a.glsl", "// x\n// Needs: PARAM_e, scene.\n" + uses),
            "shaders/mixin/a.glsl: its second line should be "
            "'// Needs: PARAM_e, a_tex, scene; may have: b_tex, count_d.'\n");
}

TEST(Lint, RefusesABadTableOfFloors) {
  EXPECT_THROW(parseFloors("base 0\n"), Error);
  EXPECT_THROW(parseFloors("0 base\n1 base\n"), Error);
  EXPECT_THROW(parseFloors("0 base but math\n"), Error);
}

TEST(Lint, FindsForeignHeadersElsewhere) {
  auto count = [](const std::vector<Source>& sources) { return lintForeignHeaders(sources).size(); };
  EXPECT_EQ(count({{"runtime/gpu/a.h", "#include <vulkan/vulkan.h>\n"}}), 0u);
  EXPECT_EQ(count({{"runtime/plan/a.h", "#include <vulkan/vulkan.h>\n"}}), 1u);
  EXPECT_EQ(count({{"runtime/graph/a.cpp", "#include \"vulkan/vulkan_core.h\"\n"}}), 1u);
  std::string twice = "#include <vulkan/vulkan.h>\n#include <vulkan/vulkan_xlib.h>\n";
  EXPECT_EQ(count({{"runtime/live/a.cpp", twice}}), 0u);
  EXPECT_EQ(count({{"runtime/live/a.cpp", twice}, {"runtime/live/b.cpp", twice}}), 2u);
  EXPECT_EQ(count({{"runtime/script/a.cpp", "#include <lua.h>\n"}}), 0u);
  EXPECT_EQ(count({{"runtime/lab/a.cpp", "extern \"C\" {\n#include <lua5.4/lauxlib.h>\n}\n#include <lua.hpp>\n"}}), 2u);
}

TEST(Lint, FindsSourcesWithoutLicence) {
  std::string line = "SPDX-License-Identifier: MIT\n";
  EXPECT_TRUE(lintLicences({{"a.lua", "-- " + line}, {"strobe", "#!/bin/sh\n# " + line}, {"a.md", "text"}}).empty());
  EXPECT_EQ(lintLicences({{"a.lua", ""}, {"b.cpp", "//\n//\n// " + line}, {"x/CMakeLists.txt", "x\n"}}).size(), 3u);
}

TEST(Lint, FindsMachines) {
  auto count = [](const std::string& text) { return lintMachines({{"docs/a.md", text}}).size(); };
  for (const char* folder : {"wor"
                             "k",
                             "hom"
                             "e",
                             "roo"
                             "t"}) {
    EXPECT_EQ(count(std::string("see /") + folder + "/somebody/x"), 1u) << folder;
    EXPECT_EQ(count(std::string("see other/") + folder + "/x"), 0u) << folder;
  }
  EXPECT_EQ(count(std::string("from deb.debian.") + "org"), 1u);
}

}  // namespace lint_test
}  // namespace strobe::repo
