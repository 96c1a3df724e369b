// SPDX-License-Identifier: MIT
// Search for files below the home's roots, and the names of these files.
#include "base/home.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/frozen_home.h"
#include "common/refusal.h"
#include "common/source.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace home_test {

namespace fs = std::filesystem;

class Homes : public ::testing::Test {
 protected:
  void write(const Path& file, const std::string& text = "") const { writeFileAtomically(folder_ / file, text); }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

TEST_F(Homes, FindFilesByName) {
  write("ours/passes/edge/b.lua");
  write("ours/passes/edge/a.lua");
  write("ours/passes/x.lua");
  write("ours/passes/x.glsl");
  Home home(folder_ / "ours");
  EXPECT_EQ(home.find("passes/edge/a.lua"), folder_ / "ours/passes/edge/a.lua");
  EXPECT_FALSE(home.find("passes/edge/c.lua"));
  EXPECT_EQ(home.at("passes/edge/c.lua"), folder_ / "ours/passes/edge/c.lua");
  EXPECT_EQ(home.namesIn("passes/edge", ".lua"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(home.namesBelow("passes", ".lua"), (std::vector<std::string>{"edge/a", "edge/b", "x"}));
  EXPECT_TRUE(home.namesBelow("nothing", ".lua").empty());
}

TEST_F(Homes, ShowPathsRelativeToTheirRoot) {
  write("ours/passes/a.lua", "text");
  Home home(folder_ / "ours");
  EXPECT_EQ(home.shown(folder_ / "ours/passes/a.lua"), "passes/a.lua");
  EXPECT_EQ(home.shown("/elsewhere/a.lua"), "/elsewhere/a.lua");
  EXPECT_EQ(home.nameOf(folder_ / "ours/passes/a.lua"), "passes/a.lua");
  EXPECT_FALSE(home.nameOf(folder_ / "other/a.lua"));
  EXPECT_EQ(home.read(folder_ / "ours/passes/a.lua"), "text");
  EXPECT_EQ(testing::refusalOf([&] { home.read(folder_ / "ours/passes/b.lua"); }),
            "passes/b.lua: cannot be read: No such file or directory");
}

TEST_F(Homes, AreLocatedFromTheProgramsPath) {
  EXPECT_EQ(Home::shippedWith(folder_ / "bin/strobe"), sourceFolder());
  write("share/strobe/scripts/strobe/pass.lua");
  EXPECT_EQ(Home::shippedWith(folder_ / "bin/strobe"), folder_ / "share/strobe");
  EXPECT_EQ(Home::shippedWith(folder_ / "elsewhere/bin/strobe"), sourceFolder());
}

// A project's root in front of the shipped root.
TEST_F(Homes, NameTheRootOfAFile) {
  write("ours/passes/a.lua");
  write("mine/passes/b.lua");
  Home home({folder_ / "mine", folder_ / "ours"});
  const Path own = folder_ / "mine/passes/b.lua", shipped = folder_ / "ours/passes/a.lua";
  EXPECT_EQ(home.recorded(own, ""), "project:passes/b.lua");
  EXPECT_EQ(home.recorded(shipped, ""), "strobe:passes/a.lua");
  EXPECT_EQ(home.recorded("/elsewhere/a.lua", "a.lua"), "a.lua");
  write("data/scenes/a.glb");
  Home with_data({folder_ / "mine", folder_ / "ours"}, folder_ / "data");
  EXPECT_EQ(with_data.recorded(folder_ / "data/scenes/a.glb", ""), "shared:scenes/a.glb");
  EXPECT_EQ(with_data.recorded(own, ""), "project:passes/b.lua");
  EXPECT_EQ(Home(folder_ / "ours").recorded(shipped, ""), "strobe:passes/a.lua");
  EXPECT_EQ(home.shown(own), "passes/b.lua");
  EXPECT_EQ(home.shown(shipped), "strobe:passes/a.lua");
  EXPECT_EQ(Home::withoutRoot(home.shown(shipped)), "passes/a.lua");
  for (const Path& file : {own, shipped}) EXPECT_EQ(home.fileShown(home.shown(file)), file);
}

TEST_F(Homes, NameFilesByTheInnerOfTwoRoots) {
  write("ours/passes/a.lua");
  write("ours/out/mine/passes/b.lua");
  Home below({folder_ / "ours/out/mine", folder_ / "ours"}), around({folder_, folder_ / "ours"});
  EXPECT_EQ(below.shown(folder_ / "ours/out/mine/passes/b.lua"), "passes/b.lua");
  EXPECT_EQ(below.shown(folder_ / "ours/passes/a.lua"), "strobe:passes/a.lua");
  EXPECT_EQ(around.shown(folder_ / "ours/passes/a.lua"), "strobe:passes/a.lua");
}

TEST_F(Homes, FollowLinksToARoot) {
  write("mine/passes/b.lua");
  write("ours/passes/a.lua");
  fs::create_directory_symlink(folder_ / "mine", folder_ / "link");
  EXPECT_EQ(Home({folder_ / "mine", folder_ / "ours"}).shown(folder_ / "link/passes/b.lua"), "passes/b.lua");
  EXPECT_EQ(Home({folder_ / "link", folder_ / "ours"}).shown(folder_ / "mine/passes/b.lua"), "passes/b.lua");
}

// The error of `find` for a project's file that has the name of a shipped file or declares that it replaces one.
std::string refusal(const Home& home, const Path& name) {
  return testing::refusalOf([&] { home.find(name); });
}

TEST_F(Homes, ReplaceOnlyFilesThatDeclareIt) {
  Home home({folder_ / "mine", folder_ / "ours"});
  const std::string undeclared =
      "passes/a.lua: has the name of a shipped file, strobe:passes/a.lua; rename it, or begin it with the line "
      "'-- replaces = true'";
  write("ours/passes/a.lua");
  for (const char* text : {"", "return { replaces = true }", "return {}\n-- replaces = true\n", "-- replaces = truely",
                           "-- it replaces = true", "local x = 1 -- replaces = true", "--[[\nreplaces = true\n]]"}) {
    write("mine/passes/a.lua", text);
    EXPECT_EQ(refusal(home, "passes/a.lua"), undeclared) << text;
    EXPECT_EQ(home.mistakesOfProject(), std::vector<std::string>{undeclared}) << text;
  }
  for (const char* text :
       {"-- replaces = true", "--replaces=true\nreturn {}", "-- A pass.\n\n  -- replaces = true\n"}) {
    write("mine/passes/a.lua", text);
    EXPECT_EQ(home.find("passes/a.lua"), folder_ / "mine/passes/a.lua") << text;
    EXPECT_TRUE(home.mistakesOfProject().empty()) << text;
  }
  write("ours/shaders/a.glsl");
  write("mine/shaders/a.glsl");
  EXPECT_NE(refusal(home, "shaders/a.glsl").find("'// replaces = true'"), std::string::npos);
  write("mine/shaders/a.glsl", "// SPDX\n// replaces = true\n");
  EXPECT_EQ(refusal(home, "shaders/a.glsl"), "");
}

TEST_F(Homes, RefuseToReplaceNothing) {
  Home home({folder_ / "mine", folder_ / "ours"});
  write("mine/pipelines/x.lua", "-- A pipeline.\n-- replaces = true\n");
  write("mine/shaders/lib/y.glsl", "// replaces = true\n");
  const std::string pipeline =
      "pipelines/x.lua:2: 'replaces = true', but strobe:scripts/pipelines/x.lua is not a shipped file";
  EXPECT_EQ(refusal(home, "scripts/pipelines/x.lua"), pipeline);
  EXPECT_EQ(home.mistakesOfProject().size(), 2u);
  write("ours/scripts/pipelines/x.lua");
  write("ours/shaders/lib/y.glsl");
  EXPECT_TRUE(home.mistakesOfProject().empty());
}

TEST_F(Homes, HaveSharedDataIfItsFolderExists) {
  EXPECT_FALSE(Home(folder_ / "ours").data());
  fs::create_directories(folder_ / "shared");
  EXPECT_EQ(Home(folder_ / "ours").data(), folder_ / "shared");
  EXPECT_FALSE(Home({folder_ / "ours"}, folder_ / "nowhere").data());
}

// The folder `other` overrides files of the home's roots; its absent.txt lists files to leave out.
TEST_F(Homes, FreezeWithOverridingFiles) {
  for (const char* file : {"passes/a.lua", "passes/b.lua", "shaders/c.glsl"}) write(Path("ours") / file, "old");
  write("mine/strobe.project.lua"), write("mine/passes/own.lua", "old");
  write("other/strobe/passes/a.lua", "new"), write("other/project/passes/more.lua", "new");
  write("other/absent.txt", "strobe/passes/b.lua\n\nstrobe/passes/gone.lua\nproject/passes/own.lua\n");
  const Home home(std::vector<Path>{folder_ / "mine", folder_ / "ours"});
  {
    FrozenHome frozen(home, folder_ / "copy", folder_ / "other");
    EXPECT_EQ(readText(frozen.home().at("passes/a.lua")), "new");
    EXPECT_TRUE(frozen.home().find("passes/more.lua"));
    EXPECT_TRUE(frozen.home().find("shaders/c.glsl"));
    EXPECT_FALSE(frozen.home().find("passes/b.lua"));
    EXPECT_FALSE(frozen.home().find("passes/own.lua"));
    EXPECT_TRUE(home.find("passes/b.lua")) << "the original is unchanged";
  }
  for (const char* name : {"passes/b.lua", "strobe/../../mine/passes/own.lua", "/strobe/passes/b.lua", "strobe"}) {
    write("other/absent.txt", std::string("strobe/passes/b.lua\n") + name + "\n");
    try {
      FrozenHome frozen(home, folder_ / "copy", folder_ / "other");
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().line, 2) << name;
    }
    EXPECT_FALSE(fs::exists(folder_ / "copy")) << name;
  }
  EXPECT_TRUE(fs::exists(folder_ / "mine/passes/own.lua"));
}

// A path into the original root maps to its copy; text in the files that names such a path is unchanged.
TEST_F(Homes, MapFilesToTheirCopies) {
  for (const char* file : {"ours/scenes/a.lua", "ours/elsewhere/b.lua", "other/passes/c.lua"}) write(file, "old");
  const Home home(folder_ / "ours");
  FrozenHome frozen(home, folder_ / "copy"), other(home, folder_ / "another", folder_ / "other");
  const Path file = folder_ / "ours/scenes/a.lua";
  EXPECT_EQ(copyOf(frozen.home(), file), folder_ / "copy/0/scenes/a.lua");
  EXPECT_EQ(frozen.at(file), folder_ / "copy/0/scenes/a.lua");
  EXPECT_EQ(copyOf(frozen.home(), frozen.at(file)), frozen.at(file));
  EXPECT_EQ(copyOf(home, file), file) << "the home is not a copy";
  EXPECT_EQ(copyOf(other.home(), file), file) << "other files replace this root";
  for (const char* name : {"ours/elsewhere/b.lua", "ours/scenes/none.lua", "other/passes/c.lua"})
    EXPECT_EQ(copyOf(frozen.home(), folder_ / name), folder_ / name);
}

}  // namespace home_test
}  // namespace strobe
