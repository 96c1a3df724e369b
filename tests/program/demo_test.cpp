// SPDX-License-Identifier: MIT
// `strobe demo` from outside: what it writes, what it refuses, and that a browser can show its page.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "base/files.h"
#include "base/json.h"
#include "image/png.h"
#include "program/run.h"

namespace strobe::testing {
namespace {

// A red quad that moves 6 px before a checker.
const char* const kScene = R"lua(
local scene = require "strobe.scene"
local red = scene.material { color = { 0.8, 0.1, 0.1 }, unlit = true }
local checker = scene.texture.checker { colors = { { 0.9, 0.9, 0.9 }, { 0.1, 0.1, 0.4 } }, count = 8 }
local wall = scene.material { color_texture = checker, unlit = true }
return scene { name = "small", nodes = {
  scene.node { name = "card", shape = scene.quad { size = { 1, 1 } }, material = red },
  scene.node { name = "wall", shape = scene.quad { size = { 8, 8 } }, material = wall, position = { 0, 0, -1 } },
  scene.node { name = "eye", camera = scene.camera { name = "main", fov = 60 }, position = { 0, 0, 2 } },
} }
)lua";

const char* const kDemo = R"lua(
local demo = require "strobe.demo"
return demo {
  title = "Small <demo> & more", size = { 64, 36 }, crop_size = { 16, 9 }, measures = { "rmse", "flip", "ms" },
  background = { column = "hybrid", front = "no blur", color = "revealed", valid = "revealed_valid" },
  expectation = { column = "hybrid", baselines = { "no blur" }, region = "inner", share = 0.5, floor = 50, contrast = 0.2 },
  columns = {
    { label = "no blur", pipeline = "none" },
    { label = "hybrid", pipeline = "PIPELINE" },
    { label = "floor", pipeline = "ground_truth", set = { samples = 4 }, role = "floor", shown = false },
    { label = "truth", pipeline = "ground_truth", set = { samples = 16 }, role = "truth" },
  },
  shots = {
    { title = "A card", scene = "SCENE", moves = { card = { 0.6, 0, 0 } }, attribution = "Card by nobody", EXTRA },
    { title = "Elsewhere", scene = "shared:no_such_scene.glb" },
  },
}
)lua";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
  return text;
}

std::string demoText(const TemporaryFolder& folder, const std::string& pipeline, const std::string& extra) {
  std::string text = replaced(kDemo, "SCENE", folder / "scene.lua");
  return replaced(replaced(text, "PIPELINE", pipeline), "EXTRA", extra);
}

void expectRefusal(const std::string& pipeline, const std::string& extra, const std::string& out,
                   const std::string& wanted) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kScene);
  writeText(folder / "demo.lua", demoText(folder, pipeline, extra));
  Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + (folder / out), "STROBE_VALIDATION=0");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Demo, MistakesAreOneLineAndWriteNothing) {
  expectRefusal("hybrid", "exposre = 0.5", "out", "did you mean 'exposure'?");
  expectRefusal("hybrid", "anchor = \"center\"", "out", "did you mean 'centre'?");
  expectRefusal("hybrd", "", "out", "did you mean 'hybrid'?");
  expectRefusal("hybrid", "camera = 3", "out", "'camera' of shot 1");
  expectRefusal("hybrid", "spins = { card = { 0, 1, 0 } }", "out", "wants 4 numbers");
  expectRefusal("hybrid", "", "scene.lua/out", "is not a folder");
}

// A mistake in a list is shown at the list's line, with its number.
TEST(Demo, MistakesHaveTheirLine) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kScene);
  writeText(folder / "demo.lua", demoText(folder, "hybrid", "exposre = 0.5"));
  Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + (folder / "out"), "STROBE_VALIDATION=0");
  EXPECT_NE(outcome.err.find("demo.lua:13: shot 1 has no field 'exposre'"), std::string::npos) << outcome.err;
}

// What a browser makes of the page, or an empty image where there is none.
image::Image screenshot(const TemporaryFolder& folder, const std::string& page) {
  if (runLine("command -v chromium").exit_code != 0) return {};
  std::string shot = folder / "page.png";
  std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir=" + (folder / "profile") +
      " --window-size=1000,1400 --screenshot=" + shot + " file://" + page + " >/dev/null 2>&1";
  if (runLine(command).exit_code != 0 || !fs::exists(shot)) return {};
  return image::readPng(shot);
}

void expectShown(const image::Image& page) {
  size_t red = 0, other = 0;
  for (int y = 0; y < page.height; ++y)
    for (int x = 0; x < page.width; ++x) {
      bool is_red = page.at(x, y, 0) > 0.7f && page.at(x, y, 1) < 0.5f && page.at(x, y, 2) < 0.5f;
      ++(is_red ? red : other);
    }
  EXPECT_GT(red, 1000u) << "the card is nowhere to be seen";
  EXPECT_GT(other, red);
}

TEST(Demo, WritesSheetPageNumbersAndRecords) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kScene);
  writeText(folder / "demo.lua", demoText(folder, "hybrid", "crops = { \"inner\", { 0, 0, 8, 8 } }"));
  std::string out = folder / "out";
  Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + out + " --markdown " + (folder / "table.md"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* file : {"demo.png", "demo.html", "demo.json", "a_card/hybrid.exr", "a_card/hybrid.png",
                           "a_card/hybrid.record.json", "a_card/truth.timings.json"})
    EXPECT_TRUE(fs::exists(out + "/" + file)) << file;
  EXPECT_NE(outcome.out.find("RMSE inner"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("about 0 s left"), std::string::npos) << "progress of pictures: " << outcome.err;
  EXPECT_NE(outcome.out.find("skipped: the"), std::string::npos) << outcome.out;
  EXPECT_NE(contentOf(folder / "table.md").find("| no blur |"), std::string::npos);

  Json json = Json::parse(contentOf(out + "/demo.json"));
  const Json& shot = json["shots"][0];
  EXPECT_NEAR(shot["median_displacement_px"].get<double>(), 4.7, 0.2);  // 0.3 m at 36 / (2 tan 30 deg) px at 2 m
  const Json& columns = shot["groups"][0]["columns"];
  ASSERT_EQ(columns.size(), 4u);
  auto rmse = [&](size_t i) { return columns[i]["errors"]["inner"]["rmse"].get<double>(); };
  EXPECT_LT(rmse(1), 0.5 * rmse(0)) << "what is behind must help";
  EXPECT_GT(rmse(2), 0.0) << "a floor has truth's own error in it";
  EXPECT_TRUE(shot["expectation"]["applies"].get<bool>()) << shot["expectation"]["text"];
  EXPECT_TRUE(columns[0]["gpu_ms"].is_number());
  EXPECT_TRUE(columns[3]["gpu_ms"].is_null()) << "truth was not warmed up";
  EXPECT_TRUE(json["shots"][1].contains("skipped"));

  std::string page = contentOf(out + "/demo.html");
  EXPECT_FALSE(std::regex_search(page.substr(0, 200000), std::regex("https?:|//[a-z]+\\.[a-z]+|@import|url\\(")));
  EXPECT_NE(page.find("Small &lt;demo&gt; &amp; more"), std::string::npos);
  EXPECT_NE(page.find("Card by nobody"), std::string::npos);
  EXPECT_LT(page.size(), 12'000'000u);
  EXPECT_GT(image::readPng(out + "/demo.png").width, 1000);

  image::Image shown = screenshot(folder, out + "/demo.html");
  if (shown.empty()) GTEST_SKIP() << "no Chromium to show the page";
  expectShown(shown);
}

}  // namespace
}  // namespace strobe::testing
