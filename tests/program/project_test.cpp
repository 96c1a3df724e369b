// SPDX-License-Identifier: MIT
// A project outside of the clone, made and used as a researcher does: own detector, pipeline, scene, reload.
#include <gtest/gtest.h>
#include <unistd.h>

#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace {

class Project : public ::testing::Test {
 protected:
  void SetUp() override {
    Outcome made = run("new '" + (folder_ / "mine") + "'");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  fs::path path(const std::string& file) const { return folder_.path() / "mine" / file; }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(path(file).parent_path());
    writeText(path(file), text);
  }

  // A command given in a folder of the project.
  Outcome inside(const std::string& arguments, const std::string& below = "") const {
    TemporaryFolder out;
    std::string command = "cd '" + path(below).string() + "' && env STROBE_VALIDATION=1 '" + programPath() + "' " +
                          arguments + " >" + (out / "out") + " 2>" + (out / "err") + " </dev/null";
    int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(out / "out"),
            contentOf(out / "err")};
  }

  void expectRefused(const std::string& arguments, const std::string& says) const {
    Outcome outcome = inside(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
  }

  // A detector that ships, under another name.
  void addDetector() const {
    std::string pass = contentOf(sourceFolder() / "passes/edge/roberts.lua");
    for (const char* from : {"edge_roberts", "edge/roberts"})
      for (size_t at; (at = pass.find(from)) != std::string::npos;) pass.replace(at + 5, 7, "mine___");
    write("passes/edge/mine.lua", pass);
    write("shaders/edge/mine___.glsl", contentOf(sourceFolder() / "shaders/edge/roberts.glsl"));
  }

  TemporaryFolder folder_;
};

const std::string kSmall = " --scene oracles/bar --size 32x18 -o out/a.exr";

TEST_F(Project, Runs) {
  Outcome drawn = inside("render smear" + kSmall, "pipelines");  // below the project's folder
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(inside("check smear").exit_code, 0);
  EXPECT_NE(inside("help").out.find("smear"), std::string::npos);
  EXPECT_NE(inside("help smear.taps").out.find("colours averaged"), std::string::npos);
  std::string record = contentOf(path("pipelines/out/a.record.json"));
  for (const char* file : {"project:pipelines/smear.lua", "project:passes/smear.lua", "project:shaders/smear.glsl",
                           "strobe:passes/scene/gbuffer.lua", "strobe:shaders/lib/hit.glsl"})
    EXPECT_NE(record.find("\"" + std::string(file) + "\""), std::string::npos) << file;
  EXPECT_EQ(inside("render none" + kSmall).exit_code, 0);
  EXPECT_NE(run("plan smear").err.find("there is no pipeline 'smear'"), std::string::npos);  // outside of it
}

TEST_F(Project, AddsMembersToFamilies) {
  addDetector();
  Outcome menu = inside("check hybrid --set mask=seed --set edge=mine");
  EXPECT_EQ(menu.exit_code, 0) << menu.err;
  EXPECT_EQ(inside("render hybrid --set mask=seed --set edge=mine" + kSmall).exit_code, 0);
  EXPECT_NE(inside("plan hybrid --set edge=mone").err.find("did you mean 'mine'"), std::string::npos);
}

TEST_F(Project, HasScenesOfItsOwn) {
  write("scenes/near.lua", contentOf(sourceFolder() / "scripts/scenes/oracles/bar.lua"));
  Outcome drawn = inside("render smear --scene near --size 32x18 -o out/a.exr");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

TEST_F(Project, AShippedNameIsRefusedUnlessItReplaces) {
  std::string text = contentOf(sourceFolder() / "scripts/pipelines/none.lua");
  write("pipelines/none.lua", text);
  expectRefused("plan none", "pipelines/none.lua: has the name of a shipped file, strobe:scripts/pipelines/none.lua");
  expectRefused("check", "pipelines/none.lua: has the name of a shipped file");
  write("pipelines/none.lua", "-- replaces = true\n" + text);
  Outcome planned = inside("plan none");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  write("passes/unused.lua", "\n-- replaces = true\nreturn {}\n");
  expectRefused("check",
                "passes/unused.lua:2: 'replaces = true', but there is no shipped file strobe:passes/unused.lua");
}

// Both roots, own experiments among them; mistakes with the file they are in.
TEST_F(Project, IsCheckedWithWhatShips) {
  Outcome sound = inside("check");
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  EXPECT_NE(sound.out.find(path("").parent_path().string() + ": 0 experiments, 1 pipelines and 0 scenes are sound\n"),
            std::string::npos)
      << sound.out;
  EXPECT_NE(sound.out.find("\n" + sourceFolder().string() + ": "), std::string::npos) << sound.out;
  write("experiments/half.lua", "return require 'strobe.experiment' { title = 'Half' }");
  expectRefused("check", "experiments/half.lua:1: ");
  EXPECT_EQ(inside("check smeer").exit_code, 2);
}

TEST_F(Project, IsMarkedInHelp) {
  Outcome topics = inside("help", "shaders");
  EXPECT_NE(topics.out.find("[project] marks what lies in " + path("").parent_path().string()), std::string::npos);
  std::istringstream lines(topics.out);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  "))
      EXPECT_EQ(line.find("[project]") != std::string::npos, line.starts_with("  smear ")) << line;
  EXPECT_NE(inside("help edge_sobel").out.find("`strobe:passes/edge/sobel.lua`, `strobe:shaders/edge/"),
            std::string::npos);
}

TEST_F(Project, ReachesItsRootsAndNothingElse) {
  writeText(folder_.path() / "secret.lua", "return {}");
  writeText(folder_.path() / "secret.glsl", "#define SECRET 1\n");
  fs::create_symlink(folder_.path() / "secret.lua", path("passes/secret.lua"));
  write("pipelines/a.lua", "return require 'passes.secret'");
  expectRefused("plan a", "leads out of");
  fs::remove(path("passes/secret.lua"));
  write("pipelines/a.lua", "return require 'passes...secret'");
  expectRefused("plan a", "is not the name of a module");

  std::string shader = contentOf(path("shaders/smear.glsl"));
  for (std::string name : {std::string("../../secret.glsl"), (folder_.path() / "secret.glsl").string()}) {
    write("shaders/smear.glsl", "#include \"" + name + "\"\n" + shader);
    expectRefused("check smear", "secret.glsl");
  }
  fs::create_symlink(folder_.path() / "secret.glsl", path("shaders/inner.glsl"));
  write("shaders/smear.glsl", "#include \"inner.glsl\"\n" + shader);
  expectRefused("check smear", "inner.glsl");
}

TEST(NewProject, RefusesWhatItCannotMake) {
  TemporaryFolder folder;
  writeText(folder / "file", "x");
  for (const std::string& name : {folder.path().string(), folder / "file", folder / "a name", folder / "-x"})
    EXPECT_EQ(run("new -- '" + name + "'").exit_code, 2) << name;
  EXPECT_EQ(run("new").exit_code, 2);
  Outcome refused = run("new /proc/mine");
  EXPECT_NE(refused.exit_code, 0) << refused.out;
  fs::create_directory(folder / "empty");
  EXPECT_EQ(run("new '" + (folder / "empty") + "'").exit_code, 0);
}

}  // namespace
}  // namespace strobe::testing
