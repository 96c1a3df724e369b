// SPDX-License-Identifier: MIT
// A user's mistake gives one line that names it, exit code 1 or 2, and no file.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "common/all_cases.h"
#include "common/home.h"
#include "program/run.h"

namespace strobe::testing {
namespace bad_input_test {

// Runs `arguments` with an output in an empty folder and expects a refusal that mentions `wanted`.
void expectRefusal(const std::string& arguments, int exit_code, const std::string& wanted,
                   const std::string& environment = "STROBE_VALIDATION=0") {
  TemporaryFolder folder;
  Outcome outcome = run(arguments + " -o " + (folder / "picture.exr"), environment);
  EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.err;
  EXPECT_NE(outcome.err.find(wanted), std::string::npos)
      << arguments << "\nsaid: " << outcome.err << "expected: " << wanted;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_TRUE(fs::is_empty(folder.path())) << arguments << " wrote a file";
}

const std::string kScene = " --scene oracles/bar --size 64x32";

TEST(BadInput, NamesAreRefusedWithTheNearest) {
  expectRefusal("render hybrd" + kScene, 2, "did you mean 'hybrid'?");
  expectRefusal("render hybrid" + kScene + " --set wights=uniform", 2, "did you mean 'weights'?");
  expectRefusal("render hybrid" + kScene + " --set raster_tile_max.tle=4", 2, "did you mean 'raster_tile_max.tile'?");
  expectRefusal("render hybrid" + kScene + " --tap gather_raster.blurrd", 2, "did you mean 'blurred'?");
  expectRefusal("render none --scene oracles/bra --size 64x32", 2, "did you mean 'oracles/bar'?");
  expectRefusal("render none" + kScene + " --move bra=1,0,0", 2, "did you mean 'bar'?");
  expectRefusal("render none" + kScene + " --camera mian", 2, "no camera 'mian'");
  expectRefusal("rendr none" + kScene, 2, "did you mean 'render'?");
}

TEST(BadInput, WrongCommandLinesSuggestACorrection) {
  expectRefusal("render hybrid --sceen x", 2, "unknown option '--sceen'; did you mean '--scene'?");
  expectRefusal("render hybrid --sise=64x32", 2, "unknown option '--sise'; did you mean '--size'?");
  expectRefusal("--hlep", 2, "unknown option '--hlep'; did you mean '--help'?");
  expectRefusal("bench reload --repeat 3", 2, "unknown option '--repeat'; did you mean '--repeats'?");
  expectRefusal("render hybrid -q", 2, "unknown option '-q'; see strobe render --help");
  expectRefusal("render hybrid none", 2, "not expected: none; see strobe render --help");
  expectRefusal("sweep", 2, "file is required; see strobe sweep --help");
  expectRefusal("sweep nowhere.lua", 1, "strobe: nowhere.lua: no such file");
  expectRefusal("sweep experiments/samples", 1, "did you mean '");
  expectRefusal("sweep experiments/samples/", 1, "experiments/samples/samples.lua'?");
  expectRefusal("render none" + kScene + " --tap gbuffer", 2,
                "'gbuffer', which is a node and not an image; use 'gbuffer.NAME' with one of ");
  expectRefusal("tune hybrid" + kScene + " --budget-ratio x", 2, "--budget-ratio: 'x' is not a number above 0");
  expectRefusal("render adaptive" + kScene + " --budget-ms -1", 2, "--budget-ms: '-1' is not a number above 0");
  for (const char* command : {"render none", "live none"})
    expectRefusal(command + kScene + " --budget-ms 5", 2,
                  "--budget-ms needs a parameter with the role 'quality', which 'none' does not have");
  expectRefusal("capture x.lua --budget-ms 5", 2,
                "'capture' has no option '--budget-ms'; it is an option of render, live, tune");
  expectRefusal("sweep x.lua --budget-ms=5", 2, "'sweep' has no option '--budget-ms'; it is an option of");
  expectRefusal("render none" + kScene + " --spin bar=0,0,0,1", 2, "--spin 'bar=0,0,0,1': the axis is 0,0,0");
}

// A shutter angle given in place of frame intervals.
TEST(BadInput, LongExposuresAreWarnedOf) {
  const std::string warning = "--exposure 180 is 180 frame intervals; a shutter of 180 degrees is --exposure 0.5";
  Outcome angle = run("plan none" + kScene + " --exposure 180");
  EXPECT_EQ(angle.exit_code, 0);
  EXPECT_NE(angle.err.find(warning), std::string::npos) << angle.err;
  EXPECT_EQ(angle.err.find(warning), angle.err.rfind(warning)) << "once";
  for (const char* shorter : {" --exposure 4", " --exposure-time 3", ""})
    EXPECT_EQ(run("plan none" + kScene + shorter).err.find("--exposure"), std::string::npos) << shorter;
}

TEST(BadInput, ValuesAreRefusedWithTheirRange) {
  expectRefusal("render hybrid" + kScene + " --set samples=0", 2, "range 1 to 1024");
  expectRefusal("render hybrid" + kScene + " --set samples=many", 2, "not an integer");
  expectRefusal("render hybrid" + kScene + " --set edge=sobl", 2, "did you mean 'sobel'?");
  for (const char* option : {"--exposure -2", "--exposure -1", "--frame -1", "--fps 0"})
    expectRefusal("render none" + kScene + " " + option, 2, std::string(option).substr(0, 5));
  expectRefusal("render none" + kScene + " --anchor middle", 2, "end, centre, start");
  expectRefusal("render none" + kScene + " --aa 0", 2, "--aa");
  expectRefusal("render none" + kScene + " --move bar=1,0", 2, "bar=1,0");
  expectRefusal("render none --scene oracles/bar --size 64", 2, "WIDTHxHEIGHT");
  expectRefusal("render none" + kScene + " --set nonsense", 2, "NAME=VALUE");
}

TEST(BadInput, MissingOrTruncatedScenesAreRefused) {
  expectRefusal("render none --scene missing.glb --size 64x32", 1, "missing.glb");
  TemporaryFolder folder;
  writeText(folder / "short.glb", "glTF\x02");
  expectRefusal("render none --size 64x32 --scene " + (folder / "short.glb"), 1, "short.glb");
  writeText(folder / "typo.lua",
            "local scene = require 'strobe.scene'\nreturn scene { name = 'x', nodes = {}, enviroment = {} }\n");
  expectRefusal("render none --size 64x32 --scene " + (folder / "typo.lua"), 1, "did you mean 'environment'?");
}

TEST(BadInput, EndlessScriptsAreStopped) {
  TemporaryFolder folder;
  writeText(folder / "hungry.lua", "local t = {}\nfor i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end\n");
  expectRefusal("render " + (folder / "hungry.lua") + kScene, 1, "of memory");
  if (!allCases()) return;
  writeText(folder / "endless.lua", "while true do end\n");
  // The limit is on processor time, as tested by script.Limits; on a busy machine the limit on wall-clock time may act
  // first.
  expectRefusal("render " + (folder / "endless.lua") + kScene, 1, "(the limit for a script)");
}

void copyHome(const TemporaryFolder& home) {
  for (const char* part : {"passes", "shaders", "scripts"})
    fs::copy(strobe::home().shipped() / part, home.path() / part, fs::copy_options::recursive);
}

// `check` compiles all passes that can be chosen; with --set, only the chosen graph.
TEST(BadInput, CheckCompilesUnusedChoices) {
  TemporaryFolder home;
  copyHome(home);
  std::string environment = "STROBE_HOME=" + home.path().string();
  fs::path shader = home.path() / "shaders/gather/uniform.glsl";
  writeText(shader, contentOf(shader) + "float broken() { return missing_name; }\n");
  Outcome outcome = run("check mcguire2012", environment);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("shaders/gather/uniform.glsl"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(run("check mcguire2012 --set weights=mcguire2012", environment).exit_code, 0);
  EXPECT_EQ(run("check mcguire2012 --set weights=uniform", environment).exit_code, 1);
  EXPECT_EQ(run("check mcguire2012 --set wieghts=uniform", environment).exit_code, 2);
  EXPECT_EQ(run("check --set weights=uniform", environment).exit_code, 2);
}

TEST(BadInput, MissingDevicesAreRefused) {
  expectRefusal("render none" + kScene, 1, "no Vulkan device", "VK_DRIVER_FILES=/nonexistent.json");
  expectRefusal("render none" + kScene + " --device nonesuch", 2, "nonesuch");
}

// A misspelt name is reported before a missing display.
TEST(BadInput, NamesAreCheckedBeforeTheDisplay) {
  for (const char* command : {"live hybrd", "live hybrid --vs mcguire2021"}) {
    Outcome outcome = run(command, "-u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_NE(outcome.err.find("did you mean"), std::string::npos) << outcome.err;
  }
  EXPECT_NE(run("live hybrid", "-u DISPLAY -u WAYLAND_DISPLAY").err.find("no window can be opened"), std::string::npos);
}

TEST(BadInput, UnwritableOutputsAreRefused) {
  Outcome outcome = run("render none" + kScene + " -o /dev/null/picture.exr");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("'/dev/null' is not a folder"), std::string::npos) << outcome.err;
  outcome = run("render none" + kScene + " -o picture.jpg");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(".exr nor .png"), std::string::npos) << outcome.err;
}

}  // namespace bad_input_test
}  // namespace strobe::testing
