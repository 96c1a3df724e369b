// SPDX-License-Identifier: MIT
// The command `strobe live` on a separate display (Xvfb), driven by files, with Vulkan's validation on. Screenshots are
// kept in live_pictures/ beside the program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "common/all_cases.h"
#include "common/home.h"
#include "image/png.h"
#include "program/run.h"

namespace strobe::testing {
namespace live_test {

// The same scene with a green card.
std::string greenScene() {
  std::string text = kCardScene;
  text.replace(text.find("0.8, 0.1, 0.1"), 13, "0.1, 0.8, 0.1");
  return text;
}

constexpr int kWidth = 1100, kHeight = 700;  // window size; the window fills its display

class Live : public ::testing::Test {
 protected:
  void SetUp() override {
    if (runLine("command -v xvfb-run").exit_code != 0) GTEST_SKIP() << "no Xvfb to open a window on";
    writeText(folder_ / "scene.lua", kCardScene);
    fs::create_directories(pictures_);
  }

  std::string shotOptions() const { return "--scene " + (folder_ / "scene.lua") + " --size 64x36 --move card=0.6,0,0"; }

  std::string command(const std::string& drive, const std::string& options) {
    writeText(folder_ / "a.drive", drive);
    return fmt::format("'{}' live {} {} --window {}x{} --out {} --drive {}", programPath(), options, shotOptions(),
                       kWidth, kHeight, folder_ / "out", folder_ / "a.drive");
  }

  // Runs a shell line on a separate display.
  Outcome onDisplay(const std::string& line) {
    writeText(folder_ / "line.sh", line);
    return runLine(fmt::format("STROBE_VALIDATION=1 timeout 120 xvfb-run -a -s '-screen 0 {}x{}x24 -noreset' sh {}",
                               kWidth, kHeight, folder_ / "line.sh"));
  }

  Outcome drive(const std::string& commands, const std::string& options = "hybrid") {
    return onDisplay(command(commands, options));
  }

  std::string picture(const std::string& name) const { return (pictures_ / name).string(); }

  TemporaryFolder folder_;
  fs::path pictures_ = fs::path(programPath()).parent_path() / "live_pictures";
};

// Pixels in the middle of the window, between the panels, whose colour passes a test.
template <class Test>
size_t countPixels(const image::Image& window, Test test) {
  size_t count = 0;
  for (int y = 50; y < window.height - 90; ++y)
    for (int x = 350; x < window.width - 350; ++x)
      count += test(window.at(x, y, 0), window.at(x, y, 1), window.at(x, y, 2));
  return count;
}

size_t redPixels(const image::Image& window) {
  return countPixels(window, [](float r, float g, float b) { return r > 0.7f && g < 0.6f && b < 0.6f; });
}

size_t greenPixels(const image::Image& window) {
  return countPixels(window, [](float r, float g, float b) { return g > 0.7f && r < 0.6f && b < 0.6f; });
}

// The window's screenshot compared with a screenshot of the display taken by ImageMagick.
TEST_F(Live, ScreenshotMatchesTheDisplay) {
  if (runLine("command -v import").exit_code != 0) GTEST_SKIP() << "no ImageMagick to look at the display";
  std::string shot = picture("start.png"), seen = folder_ / "seen.png";
  fs::remove(shot);
  std::string line = command("wait 3\nscreenshot " + shot + "\nwait 150\nquit\n", "hybrid") + " &\npid=$!\n" +
                     "for i in $(seq 300); do test -f " + shot + " && break; sleep 0.1; done\nsleep 0.3\n" +
                     "import -window root " + seen + "\nwait $pid\n";
  Outcome outcome = onDisplay(line);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  image::Image window = image::readPng(shot), display = image::readPng(seen);
  ASSERT_EQ(window.width, kWidth);
  ASSERT_EQ(window.height, kHeight);
  ASSERT_EQ(display.width, kWidth);
  size_t differ = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) differ += window.at(x, y, c) != display.at(x, y, c);
  EXPECT_EQ(differ, 0u);
  EXPECT_GT(redPixels(window), 500u) << "the card is not visible";
}

// A saved picture equals the result of `render` with the window's command, independent of earlier views.
TEST_F(Live, CaptureEqualsRender) {
  std::string capture = folder_ / "capture.exr", again = folder_ / "again.exr";
  Outcome outcome = drive(
      "set exposure 0.75\nset edge prewitt\nview gbuffer.velocity\nwait 2\nkind arrows\nwait 2\n"
      "expect exposure 0.75\nexpect edge prewitt\norbit 20 10\nkey C\ninspect 32 18\ntrail " +
      (folder_ / "trail.json") + "\ncapture " + capture + "\nquit\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Outcome rendered = run("render hybrid " + shotOptions() + " --exposure 0.75 --set edge=prewitt -o " + again);
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  Json of_window = Json::parse(contentOf(folder_ / "capture.record.json"));
  Json of_render = Json::parse(contentOf(folder_ / "again.record.json"));
  ASSERT_FALSE(of_window["outputs"].empty());
  EXPECT_EQ(of_window["outputs"], of_render["outputs"]);
  Json trail = Json::parse(contentOf(folder_ / "trail.json"));
  EXPECT_EQ(trail["pixel"], Json({32, 18}));
  EXPECT_GT(trail["passes"].size(), 5u);
}

TEST_F(Live, EditsApplyAndMistakesDimTheLastGoodFrame) {
  writeText(folder_ / "green.lua", greenScene());
  writeText(folder_ / "broken.lua", std::string(kCardScene) + "\nthis is no Lua\n");
  std::string scene = folder_ / "scene.lua", green = folder_ / "green.lua", broken = folder_ / "broken.lua";
  Outcome outcome =
      drive("problems no\nreplace " + scene + " " + green + "\nreloaded\nwait 2\nproblems no\nscreenshot " +
            picture("green.png") + "\nreplace " + scene + " " + broken + "\nreloaded\nproblems yes\nscreenshot " +
            picture("broken.png") + "\nreplace " + scene + " " + green + "\nreloaded\nproblems no\nscreenshot " +
            picture("mended.png") + "\nquit\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  image::Image edited = image::readPng(picture("green.png")), dimmed = image::readPng(picture("broken.png"));
  image::Image mended = image::readPng(picture("mended.png"));
  EXPECT_GT(greenPixels(edited), 500u);
  EXPECT_EQ(redPixels(edited), 0u);
  EXPECT_EQ(greenPixels(dimmed), 0u) << "the last good frame is dimmed";
  EXPECT_EQ(greenPixels(mended), greenPixels(edited));
}

// The trail of a pixel is computed with the newest files, which may be broken.
TEST_F(Live, BrokenScriptWithAPinnedPixelKeepsTheWindow) {
  std::string own = folder_ / "own.lua", good = folder_ / "good.lua", broken = folder_ / "broken.lua";
  std::string text = readText(strobe::home().shipped() / "scripts/pipelines/mcguire2012.lua");
  writeText(own, text);
  writeText(good, text + "\n-- mended\n");
  writeText(broken, text + "\nthis is no Lua\n");
  Outcome outcome =
      drive("inspect 3 3\nproblems no\nreplace " + own + " " + broken + "\nreloaded\nframe 2\nwait 3\nproblems yes\n" +
                "replace " + own + " " + good + "\nreloaded\nframe 1\nwait 3\nproblems no\nquit\n",
            own);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// Edits of shipped files and of the project's files; a mistake has the project's path.
TEST_F(Live, WatchesProjectAndShippedFiles) {
  fs::path project = folder_.path() / "mine", home = folder_.path() / "home";
  fs::create_directories(home);
  for (const char* part : {"passes", "scripts", "shaders", "project"})
    fs::copy(strobe::home().shipped() / part, home / part, fs::copy_options::recursive);
  std::string environment = "STROBE_HOME=" + home.string();
  ASSERT_EQ(run("new " + project.string(), environment).exit_code, 0);
  std::string shade = home / "shaders/gbuffer/shade.glsl", own = project / "shaders/smear.glsl";
  std::string green = std::regex_replace(contentOf(shade), std::regex("vec4\\(color, 1\\)"), "vec4(0, 1, 0, 1)");
  writeText(folder_ / "shade.glsl", contentOf(shade));
  writeText(folder_ / "green.glsl", green);
  writeText(folder_ / "broken.glsl", "nonsense\n" + contentOf(own));
  Outcome outcome =
      onDisplay("cd " + project.string() + "\nexport " + environment + "\n" +
                command("replace " + shade + " " + (folder_ / "green.glsl") +
                            "\nreloaded\nwait 2\nproblems no\nscreenshot " + picture("shipped.png") + "\nreplace " +
                            own + " " + (folder_ / "broken.glsl") + "\nreloaded\nwait 2\nproblems yes\nquit\n",
                        "smear"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(greenPixels(image::readPng(picture("shipped.png"))), 500u);
  EXPECT_NE(outcome.err.find("reloaded strobe:shaders/gbuffer/shade.glsl"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("\n  shaders/smear.glsl:"), std::string::npos) << outcome.err;
}

TEST_F(Live, TwoPipelinesAreComparedAtOneTime) {
  std::string names[] = {"wipe", "difference", "error"};
  std::string commands = "frame 2\n";
  for (const std::string& name : names)
    commands +=
        "mode " + name + "\n" + (name == "error" ? "truth 16\n" : "") + "screenshot " + picture(name + ".png") + "\n";
  commands +=
      "mode flicker\nwait 15\nmode single\nplay on\nwait 4\nplay off\nexpect frame 6\nframe 1\nhelp on\nscreenshot " +
      picture("help.png") + "\nhelp off\nresize 900x600\nwait 4\npanels off\nscreenshot " + picture("alone.png") +
      "\nkey F10\n";
  Outcome outcome = drive(commands, "hybrid --vs hybrid --vs-set edge=id");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const std::string& name : names) EXPECT_EQ(image::readPng(picture(name + ".png")).width, kWidth);
  image::Image alone = image::readPng(picture("alone.png"));
  EXPECT_EQ(alone.width, 900);
  EXPECT_EQ(alone.height, 600);
  EXPECT_GT(redPixels(alone), 500u);
}

// Sweeps by keys and mouse: sweeps the control found by a search, clicks on a column to take its value, and runs the
// saved sweep.
TEST_F(Live, SweepIsDrawnTakenAndSaved) {
  std::string file = folder_ / "sweep.lua", study = folder_ / "study";
  Outcome outcome = drive(
      "search samples\nkey R\nwait 2\nkey Escape\nsearch\nsweep samples=4,8,16\nswept\nscreenshot " +
          picture("sweep.png") + "\nclick 397 560\nexpect samples 4\nkey .\nexpect samples 8\n" + "experiment " + file +
          "\nkey F5\nsweep samples=4,8,16 tile=10,20\nswept\nscreenshot " + picture("sweep_grid.png") +
          "\nset exposure 1\nwait 3\nscreenshot " + picture("sweep_stale.png") + "\nkey Escape\nproblems no\nquit\n",
      "mcguire2012");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"sweep.png", "sweep_grid.png"}) {
    image::Image window = image::readPng(picture(name));
    size_t red = 0;  // red pixels of cards in thumbnails
    for (int y = window.height / 2; y < window.height - 90; ++y)
      for (int x = 350; x < window.width - 350; ++x)
        red += window.at(x, y, 0) > 0.7f && window.at(x, y, 1) < 0.5f && window.at(x, y, 2) < 0.45f;
    EXPECT_GT(red, 100u) << name;
  }
  size_t saved = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "out")) saved += entry.path().extension() == ".lua";
  EXPECT_EQ(saved, 1u);
  Outcome listed = run("sweep " + file + " --dry-run --json");
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_EQ(Json::parse(listed.out).size(), 3u);
  Outcome swept = run("sweep " + file + " --size 32x18 -o " + study, "STROBE_VALIDATION=1");
  EXPECT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_TRUE(fs::exists(study + "/report.html"));
}

// ---- recordings

// Colour hash and name of each picture in a capture's manifest.
std::map<std::string, std::string> coloursOf(const fs::path& capture) {
  std::map<std::string, std::string> names;
  Json manifest = Json::parse(contentOf(capture / "manifest.json"));
  for (const Json& picture : manifest["pictures"]) names[picture["record"]["outputs"]["color"]] = picture["name"];
  return names;
}

std::vector<std::string> savedColours(const fs::path& folder) {
  std::vector<std::string> hashes;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().string().ends_with(".record.json"))
      hashes.push_back(Json::parse(contentOf(entry.path()))["outputs"]["color"]);
  return hashes;
}

// Values, another pipeline, a camera, played frames, an edited shader: the script draws each saved picture again, also
// after further edits.
TEST_F(Live, RecordingDrawsTheSavedPicturesAgain) {
  const std::string home = folder_ / "home", shade = home + "/shaders/gbuffer/shade.glsl";
  fs::create_directories(home);
  for (const char* part : {"passes", "scripts", "shaders"})
    fs::copy(strobe::home().shipped() / part, fs::path(home) / part, fs::copy_options::recursive);
  const std::string before = contentOf(shade);
  const std::string green = std::regex_replace(before, std::regex("vec4\\(color, 1\\)"), "vec4(0, color.g, 0, 1)");
  ASSERT_NE(green, before);
  writeText(folder_ / "green.glsl", green);
  const std::string script = folder_ / "recorded.lua", capture = folder_ / "capture";
  Outcome outcome = onDisplay(
      "export STROBE_HOME=" + home + "\n" +
      command("wait 2\nrecord\nwait 1\nset samples 8\nwait 2\nkey F2\nset exposure 0.75\norbit 20 10\nwait 2\nkey F2\n"
              "replace " +
                  shade + " " + (folder_ / "green.glsl") +
                  "\nreloaded\nwait 2\nkey F2\n"
                  "pipeline mcguire2012\nplay on\nwait 4\nplay off\nwait 2\nkey F2\nrecording " +
                  script + "\nquit\n",
              "hybrid"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  writeText(shade, std::regex_replace(before, std::regex("vec4\\(color, 1\\)"), "vec4(0, 0, 1, 1)"));
  Outcome taken = run("capture " + script + " -o " + capture, "STROBE_VALIDATION=1 STROBE_HOME=" + home);
  ASSERT_EQ(taken.exit_code, 0) << taken.err;
  auto drawn = coloursOf(capture);
  std::vector<std::string> saved = savedColours(folder_ / "out");
  EXPECT_EQ(saved.size(), 4u);
  EXPECT_EQ(std::set<std::string>(saved.begin(), saved.end()).size(), 4u) << "all pictures differ";
  for (const std::string& hash : saved) EXPECT_TRUE(drawn.count(hash)) << hash << "\n" << contentOf(script);
  EXPECT_TRUE(fs::exists(capture + "/recorded.png"));
  Outcome verified = run("verify " + capture, "STROBE_VALIDATION=0 STROBE_HOME=" + home);
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  for (const auto& entry : fs::directory_iterator(folder_ / "out"))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

TEST_F(Live, BudgetChoosesTheQuality) {
  const std::string shot = picture("budget.png");
  Outcome outcome = drive("wait 60\nexpect quality 1\nscreenshot " + shot +
                              "\nset quality 0.5\nwait 20\nexpect quality 0.5\nproblems no\nquit\n",
                          "adaptive --budget-ms 1000000");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(Live, ClosingTheWindowKeepsTheRecording) {
  Outcome outcome = drive("wait 2\nrecord\nset samples 8\nwait 2\nquit\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::string script = folder_ / "out/hybrid_scene_f1_001.recording.lua";
  EXPECT_NE(outcome.err.find("recorded: " + script), std::string::npos) << outcome.err;
  EXPECT_NE(contentOf(script).find("set = { samples = 8 }"), std::string::npos) << contentOf(script);
}

// Events of a keyboard and a mouse: F6, a drag over the picture, F2, next frame, F2, the wheel, F2, F6.
TEST_F(Live, KeyboardAndMouseAreRecorded) {
  if (runLine("command -v xdotool").exit_code != 0) GTEST_SKIP() << "no xdotool to press keys";
  const std::string out = folder_ / "out", editor = folder_ / "editor.sh", opened = folder_ / "opened.lua";
  writeText(editor, "#!/bin/sh\ncp \"$1\" " + opened + "\n");
  fs::permissions(editor, fs::perms::owner_all);
  Outcome outcome = onDisplay(fmt::format(
      "export STROBE_EDITOR={}\n'{}' live hybrid {} --window {}x{} --out {} &\npid=$!\n"
      "saved() {{ for i in $(seq 100); do test $(ls {}/*.exr 2>/dev/null | wc -l) -ge $1 && return; sleep 0.1; done; "
      "}}\n"
      "xdotool search --sync --onlyvisible --name 'strobe live' windowfocus\nsleep 1\nxdotool key F6\nsleep 0.5\n"
      "xdotool mousemove 550 300 mousedown 1\nfor x in 560 570 580 590; do xdotool mousemove $x 310; sleep 0.1; done\n"
      "xdotool mouseup 1\nsleep 0.5\nxdotool key F2\nsaved 1\nxdotool key Right\nsleep 0.5\nxdotool key F2\nsaved 2\n"
      "xdotool mousemove 550 300 click 4\nsleep 0.5\nxdotool key F2\nsaved 3\nxdotool key F6\n"
      "for i in $(seq 50); do test -s {} && break; sleep 0.1; done\nxdotool key F10\nwait $pid\n",
      editor, programPath(), shotOptions(), kWidth, kHeight, out, out, opened));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_TRUE(fs::exists(opened)) << "the editor did not get the script";
  Outcome taken = run("capture " + opened + " -o " + (folder_ / "capture"), "STROBE_VALIDATION=0");
  ASSERT_EQ(taken.exit_code, 0) << taken.err;
  auto drawn = coloursOf(folder_ / "capture");
  std::vector<std::string> saved = savedColours(out);
  EXPECT_EQ(std::set<std::string>(saved.begin(), saved.end()).size(), 3u);
  for (const std::string& hash : saved) EXPECT_TRUE(drawn.count(hash)) << hash << "\n" << contentOf(opened);
}

// Keys arrive at typing speed while a step of truth takes longer than a key: all keys go to the text box and no key
// moves the camera. The sweep is of the control found by the text.
TEST_F(Live, KeysOfATextBoxArriveWhileTruthGathers) {
  if (!allCases()) GTEST_SKIP() << "runs with --all";
  if (runLine("command -v xdotool").exit_code != 0) GTEST_SKIP() << "no xdotool to press keys";
  const std::string out = folder_ / "out";
  Outcome outcome = onDisplay(fmt::format(
      "'{}' live none --scene {} --size 640x360 --move card=0.6,0,0 --window {}x{} --out {} &\npid=$!\n"
      "xdotool search --sync --onlyvisible --name 'strobe live' windowfocus\nsleep 1\nxdotool key 5\nsleep 2\n"
      "xdotool type --delay 60 '/wasd'\nxdotool key ctrl+a\nxdotool type --delay 60 'exposure of'\n"
      "xdotool key Escape\nxdotool type --delay 60 '/anchor'\nxdotool key Return r\nsleep 1\nxdotool key F5\n"
      "for i in $(seq 100); do ls {}/*.lua >/dev/null 2>&1 && break; sleep 0.1; done\nxdotool key F10\nwait $pid\n",
      programPath(), folder_ / "scene.lua", kWidth, kHeight, out, out));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_TRUE(fs::exists(out)) << outcome.err;
  std::vector<std::string> saved;
  for (const auto& entry : fs::directory_iterator(out)) saved.push_back(entry.path().filename());
  ASSERT_EQ(saved, std::vector<std::string>{"none_scene_f1_001.anchor.lua"});
  EXPECT_EQ(contentOf(fs::path(out) / saved[0]).find("view"), std::string::npos) << "the camera did not move";
}

TEST_F(Live, FailedCommandEndsWithItsLine) {
  Outcome outcome = drive("wait 1\nexpect exposure 0.123\nquit\n");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("a.drive:2: exposure is 0.5, expected 0.123"), std::string::npos) << outcome.err;
  outcome = drive("resize 12\n");
  EXPECT_NE(outcome.err.find("resize '12' is not WIDTHxHEIGHT"), std::string::npos) << outcome.err;
  outcome = drive("set edge sobell\n");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("a.drive:1: 'set' failed: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("did you mean 'sobel'?"), std::string::npos) << outcome.err;
}

// A pass that never ends is named, and the shot is saved so that it can be opened again.
TEST_F(Live, EndlessShaderIsNamedAndTheShotIsKept) {
  fs::path home = folder_.path() / "home";
  fs::create_directories(home);
  for (const char* part : {"passes", "scripts", "shaders"})
    fs::copy(strobe::home().shipped() / part, home / part, fs::copy_options::recursive);
  fs::path shader = home / "shaders/tile/tile_max.glsl";
  std::string text = contentOf(shader), head = "void run(ivec2 tile) {\n";
  ASSERT_NE(text.find(head), std::string::npos);
  text.insert(text.find(head) + head.size(),
              "  while (texelFetch(velocity_tex, tile, 0).x < 1e30) imageStore(longest_img, tile, vec4(1));\n");
  writeText(shader, text);
  std::string line = "export STROBE_HOME=" + home.string() + "\n" + command("wait 2\nquit\n", "hybrid --time-limit 2");
  Outcome outcome = onDisplay(line);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("ran for more than 2 s"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("tile_max"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/overrun.record.json"));
  Outcome again = run("render --record " + (folder_ / "out/overrun.record.json") + " -o " + (folder_ / "x.exr"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST(LiveWithoutDisplay, NamesTheMissingDisplay) {
  Outcome outcome = run("live hybrid", "DISPLAY= WAYLAND_DISPLAY=");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("no window can be opened here"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace live_test
}  // namespace strobe::testing
