// SPDX-License-Identifier: MIT
// A recording while files are edited and created: each version has the files of its time, and the script leaves out the
// suggestions of the scene at that time. program/live_test.cpp draws the pictures again.
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <regex>
#include <thread>

#include "base/frozen_home.h"
#include "live/recording.h"
#include "oracle/render.h"
#include "program/run.h"

namespace strobe::live {
namespace recorded_files_test {

namespace fs = std::filesystem;

using RecordedFiles = oracle::RenderTest;

std::string sceneWith(const std::string& exposure) {
  return std::regex_replace(std::string(testing::kCardScene), std::regex("name = \"small\","),
                            "name = \"small\", shot = { exposure = " + exposure + " },");
}

void turn(Desk& desk, Recording& recording) {
  recording.lookAtFiles();
  for (int i = 0; i < 3; ++i) desk.turn();
  recording.look(desk, false);
}

TEST_F(RecordedFiles, EachVersionHasTheFilesOfItsTime) {
  testing::TemporaryFolder folder;
  FrozenHome copy(bench().home(), folder.path() / "home");
  const Home& home = copy.home();
  const Path scene = home.shipped() / "scripts/scenes/edited.lua", made = home.shipped() / "passes/mask/made.lua";
  writeFileAtomically(scene, sceneWith("0.5"));
  lab::Workbench own(home, bench());
  DeskOptions options;
  options.shot.scene = "edited", options.shot.pipeline = "none";
  options.shot.width = 32, options.shot.height = 18;
  Desk desk(own, options);
  Recording recording(home, folder.path() / "recorded");
  turn(desk, recording);
  desk.sides().set("exposure", "0.75", "window");
  turn(desk, recording);
  writeFileAtomically(made, readText(home.shipped() / "passes/mask/moving.lua"));
  writeFileAtomically(scene, sceneWith("0.75"));
  for (int i = 0; i < 1000 && desk.sides().swaps() == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    desk.turn();
  }
  turn(desk, recording);
  recording.write(folder.path() / "it.lua", own.limits);

  const Path before = folder.path() / "it/files_1", after = folder.path() / "it/files_2";
  EXPECT_EQ(readText(before / "strobe/scripts/scenes/edited.lua"), sceneWith("0.5"));
  EXPECT_EQ(readText(before / FrozenHome::kAbsent), "strobe/passes/mask/made.lua\n");
  EXPECT_EQ(readText(after / "strobe/scripts/scenes/edited.lua"), sceneWith("0.75"));
  EXPECT_TRUE(fs::exists(after / "strobe/passes/mask/made.lua"));
  EXPECT_FALSE(fs::exists(after / FrozenHome::kAbsent));
  EXPECT_FALSE(FrozenHome(home, folder.path() / "again", before).home().find("passes/mask/made.lua"));
  EXPECT_TRUE(FrozenHome(home, folder.path() / "again", after).home().find("passes/mask/made.lua"));

  const std::string text = readText(folder.path() / "it.lua");
  for (const char* line :
       {"{ name = \"view\", scene = \"edited\" }", "{ name = \"view_2\", scene = \"edited\", exposure = 0.75 }",
        "files = \"it/files_1\", shots = { \"view\", \"view_2\" }", "files = \"it/files_2\", shots = { \"view\" }"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\nin\n" << text;
}

// A new file does not change the picture until it is chosen; a shader created after its pass belongs to no earlier
// version.
TEST_F(RecordedFiles, NewFileIsInAllLaterVersions) {
  testing::TemporaryFolder folder;
  FrozenHome copy(bench().home(), folder.path() / "home");
  const Home& home = copy.home();
  const Path made = home.shipped() / "passes/edge/made.lua", shader = home.shipped() / "shaders/edge/made.glsl";
  lab::Workbench own(home, bench());
  DeskOptions options;
  options.shot = oracle::with(oracle::shotOf("bar", 32, 16), "hybrid", {});
  Desk desk(own, options);
  Recording recording(home, folder.path() / "recorded");
  auto turns_until = [&](auto done) {
    for (int i = 0; i < 500 && !done(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      recording.lookAtFiles();
      desk.turn();
      recording.look(desk, false);
    }
    EXPECT_TRUE(done());
  };
  auto drawn = [&] { return !desk.busy(); };
  turns_until(drawn);
  recording.markSaved(desk);
  const std::string declared = readText(home.shipped() / "passes/edge/sobel.lua");
  writeFileAtomically(made, std::regex_replace(declared, std::regex("edge([_/])sobel"), "edge$1made"));
  turns_until([&] { return desk.sides().reloads() == 1; });
  EXPECT_EQ(desk.sides().swaps(), 0) << "no pass of the pipeline uses the new file";
  EXPECT_EQ(desk.sides().takeMessage(), "new choice edge = made");
  writeFileAtomically(shader, readText(home.shipped() / "shaders/edge/sobel.glsl"));
  desk.sides().set("edge", "made", "window");
  turns_until(drawn);
  recording.markSaved(desk);
  writeFileAtomically(shader, readText(shader) + "\n// edited\nconst float kNothing = 0;\n");
  turns_until([&] { return desk.sides().swaps() == 1 && !desk.busy(); });
  recording.markSaved(desk);
  recording.write(folder.path() / "it.lua", own.limits);

  const std::string text = readText(folder.path() / "it.lua");
  std::map<std::string, int> arms;  // key: version of the files
  const std::regex arm("edge = \"made\"[^\\n]*files = \"it/files_([0-9])\"");
  for (std::sregex_iterator it(text.begin(), text.end(), arm), end; it != end; ++it) ++arms[(*it)[1]];
  EXPECT_EQ(arms.size(), 2u) << "with the first and the edited version of the shader\n" << text;
  for (const auto& [number, count] : arms) {
    const Path version = folder.path() / ("it/files_" + number);
    FrozenHome again(home, folder.path() / "again", version);
    EXPECT_TRUE(again.home().find("passes/edge/made.lua")) << version;
    EXPECT_EQ(readText(again.home().at("shaders/edge/made.glsl")).ends_with("kNothing = 0;\n"),
              number == arms.rbegin()->first);
  }
}

TEST(Editor, GetsItsArguments) {
  testing::TemporaryFolder folder;
  const std::string program = folder / "editor", seen = folder / "seen", file = folder / "a script.lua";
  testing::writeText(
      program, "#!/bin/sh\nfor a in \"$@\"; do echo \"$a\"; done > " + seen + ".part\nmv " + seen + ".part " + seen);
  fs::permissions(program, fs::perms::owner_all);
  ::setenv("STROBE_EDITOR", (program + "  --wait -n; ").c_str(), 1);
  openInEditor(file);
  for (int i = 0; i < 500 && !fs::exists(seen); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(testing::contentOf(seen), "--wait\n-n;\n" + file + "\n");
  ::unsetenv("STROBE_EDITOR");
}

}  // namespace recorded_files_test
}  // namespace strobe::live
