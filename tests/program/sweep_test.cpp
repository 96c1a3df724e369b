// SPDX-License-Identifier: MIT
// The commands `strobe demo`, `sweep` and `report`: written files, refusals, and the page in a browser.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "base/files.h"
#include "base/json.h"
#include "common/all_cases.h"
#include "image/png.h"
#include "program/run.h"

namespace strobe::testing {
namespace sweep_test {

const char* const kDemo = R"lua(
local capture = require "strobe.capture"
return capture {
  title = "Small <demo> & more", size = { 64, 36 }, measures = { "rmse", "flip", "ms" },
  background = { arm = "hybrid", front = "no blur", color = "revealed", valid = "revealed_valid" },
  arms = {
    { name = "no blur", pipeline = "none" },
    { name = "hybrid", pipeline = "PIPELINE" },
    { name = "floor", pipeline = "ground_truth", set = { samples = 4 }, role = "floor", shown = false },
    { name = "truth", pipeline = "ground_truth", set = { samples = 16 }, layers = { "inner", "velocity", "id" } },
  },
  truth = "truth", layers = {},
  shots = {
    { name = "card", title = "A card", scene = "scene.lua", move = { card = { 0.6, 0, 0 } }, attribution = "Card by nobody", EXTRA },
    { name = "elsewhere", title = "Elsewhere", scene = "shared:no_such_scene.glb" },
  },
  expect = {
    { "the background helps", shot = "card", function(r)
      local own, without = r.at { arm = "hybrid", region = "inner" }, r.at { arm = "no blur", region = "inner" }
      if own.background_deviation < 0.2 * own.background_difference then return nil end
      return own.rmse < 0.5 * without.rmse, ("%.3f"):format(own.rmse / without.rmse)
    end },
    { "something of a shot that is not here", shot = "elsewhere", function(r) return r.at { shot = "elsewhere" }.rmse > 9 end },
    EXPECTED
  },
  layout = { pictures = { crop_size = { 16, 9 } } },
  figures = { { name = "figure", shot = "card", cell_width = 480, boxes = { { area = { "inner", 16, 9 } } },
    columns = { { arm = "no blur" }, { arm = "hybrid" } },
    rows = { { title = "A card", note = "{size}, {displacement}", caption = "RMSE {rmse inner}" },
             { crop = { "inner", 16, 9 } }, { against = "truth", difference = "channels", gain = 4 } } } },
}
)lua";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
  return text;
}

std::string demoText(const std::string& pipeline, const std::string& extra, const std::string& expected = "") {
  std::string text = replaced(kDemo, "EXPECTED", expected);
  return replaced(replaced(text, "PIPELINE", pipeline), "EXTRA", extra);
}

TEST(Demo, MistakeIsOneLineAndWritesNothing) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  writeText(folder / "demo.lua", demoText("hybrid", "exposre = 0.5"));
  for (const auto& [out, wanted] :
       {std::pair("out", "demo.lua:14: shot 1 has no field 'exposre'; did you mean 'exposure'?"),
        {"scene.lua/out", "is not a folder"}}) {
    Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + (folder / out), "STROBE_VALIDATION=0");
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
}

// Screenshot of the page in a browser; empty without Chromium.
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
  EXPECT_GT(red, 1000u) << "the card is not visible";
  EXPECT_GT(other, red);
}

TEST(Demo, WritesFigurePageNumbersAndRecords) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  writeText(folder / "demo.lua", demoText("hybrid", "crops = { \"inner\", { 0, 0, 8, 8 } }"));
  std::string out = folder / "out";
  Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + out);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* file :
       {"figure.png", "figure.pdf", "manifest.json", "pictures/card.floor.exr", "demo.html", "demo.json", "table.csv",
        "a_card/hybrid.exr", "a_card/hybrid.png", "a_card/hybrid.record.json", "a_card/truth.timings.json"})
    EXPECT_TRUE(fs::exists(out + "/" + file)) << file;
  EXPECT_NE(outcome.out.find("RMSE inner"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("about 0 s left"), std::string::npos) << "progress of pictures: " << outcome.err;
  EXPECT_NE(outcome.out.find("skipped: the"), std::string::npos) << outcome.out;
  EXPECT_NE(contentOf(out + "/demo.md").find("| no blur |"), std::string::npos);

  Json json = Json::parse(contentOf(out + "/demo.json"));
  ASSERT_EQ(json["groups"].size(), 1u) << "the other shot is left out";
  const Json& points = json["groups"][0]["points"];
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0]["role"], "truth");
  auto value = [&](size_t i, const char* measure, const char* region) {
    return points[i]["values"][measure][region].get<double>();
  };
  // 0.3 m at a distance of 2 m, with 36 / (2 tan 30 deg) px per unit slope.
  EXPECT_NEAR(value(0, "displacement", "all"), 4.7, 0.2);
  EXPECT_LT(value(2, "rmse", "inner"), 0.5 * value(1, "rmse", "inner")) << "the background must reduce the error";
  EXPECT_GT(value(3, "rmse", "inner"), 0.0) << "the noise floor includes truth's own error";
  EXPECT_EQ(json["expectations"][0]["outcome"], "holds") << json["expectations"][0];
  EXPECT_EQ(json["expectations"][1]["outcome"], "does not apply");
  EXPECT_GT(value(1, "ms", "all"), 0);
  EXPECT_FALSE(points[0]["values"].contains("ms")) << "truth is not timed";
  EXPECT_NE(json["shots"][1]["missing"].get<std::string>().find("no_such_scene"), std::string::npos);

  // `report` writes the same page from the stored files.
  std::string page = contentOf(out + "/demo.html");
  Outcome again = run("report " + out);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(contentOf(out + "/demo.html"), page);
  EXPECT_FALSE(std::regex_search(page.substr(0, std::min<size_t>(200000, page.find("<script"))),
                                 std::regex("https?:|//[a-z]+\\.[a-z]+|@import|url\\(")));
  EXPECT_NE(page.find("Small &lt;demo&gt; &amp; more"), std::string::npos);
  EXPECT_NE(page.find("Card by nobody"), std::string::npos);
  EXPECT_LT(page.size(), 12'000'000u);
  EXPECT_EQ(image::readPng(out + "/figure.png").width, 2 * 480 + 6 + 2 * 12) << "crops decide the width";

  // Each picture was drawn once: the measured picture is the picture in the manifest.
  Json manifest = Json::parse(contentOf(out + "/manifest.json"));
  ASSERT_EQ(manifest["pictures"].size(), 4u);
  for (const Json& picture : manifest["pictures"])
    for (const Json& point : points) {
      if (point["arm"] != picture["arm"]) continue;
      EXPECT_EQ(point["image"], picture["record"]["outputs"]["color"]) << point["arm"];
    }
  Json timings = Json::parse(contentOf(out + "/timings.json"));
  for (const Json& point : points) {
    if (point["role"] == "truth") continue;  // read from the stored truth
    std::string own = "a_card/" + point["arm"].get<std::string>();
    std::replace(own.begin(), own.end(), ' ', '_');
    EXPECT_EQ(Json::parse(contentOf(out + "/" + own + ".timings.json")),
              timings["card." + own.substr(own.find('/') + 1)]);
  }
  Outcome verified = run("verify " + out);
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;

  image::Image shown = screenshot(folder, out + "/demo.html");
  if (shown.empty()) GTEST_SKIP() << "no Chromium to show the page";
  expectShown(shown);
}

// The shipped demo has a table, a figure and a manifest; with --all, a second run gives the same files.
TEST(Demo, ShippedDemoIsACaptureWithATable) {
  TemporaryFolder folder;
  std::string out = folder / "out";
  Outcome outcome = run("demo --size 64x36 -o " + out, "STROBE_VALIDATION=0");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("This holds (RMSE"), std::string::npos) << outcome.out;
  EXPECT_GT(image::readPng(out + "/demo.png").width, 6 * 480);
  std::string table = contentOf(out + "/table.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 2 * 7 * 4) << "shots, arms, regions";
  Json manifest = Json::parse(contentOf(out + "/manifest.json"));
  EXPECT_EQ(manifest["capture"]["file"], "strobe:scripts/captures/demo.lua");
  EXPECT_EQ(manifest["pictures"].size(), 16u);
  if (!allCases()) return;
  Outcome verified = run("verify " + out, "STROBE_VALIDATION=0");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

TEST(Demo, RefusesUnmeasuredValues) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  auto refused = [&](const std::string& from, const std::string& to, const std::string& wanted) {
    std::string text = demoText("hybrid", "");
    ASSERT_NE(text.find(from), std::string::npos) << from;
    writeText(folder / "demo.lua", replaced(text, from, to));
    Outcome outcome = run("demo " + (folder / "demo.lua") + " -o " + (folder / "out"), "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
  };
  refused("measures =", "-- measures =", "demo.lua:5: a capture with 'background' needs `measures`");
  refused("\"flip\", \"ms\"", "\"flop\"", "did you mean 'flip'?");
  refused("truth = \"truth\", ", "", "measures compare pictures with truth, but the capture has no 'truth' arm");
  refused("role = \"floor\"", "role = \"flor\"", "demo.lua:9: the role of an arm is 'flor'");
  refused("return capture", "do return require \"strobe.experiment\" { title = \"x\" } end return capture",
          "is an experiment, not a capture { ... }: run it with `strobe sweep`");
  refused("move =", "vary = { exposure = { 0.1, 0.2 } }, move =", "a shot with vary cannot be measured");
}

// A picture of one size does not replace a picture of another size with the same name.
TEST(Demo, DrawsAgainAtAnotherSize) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  writeText(folder / "demo.lua", demoText("hybrid", ""));
  std::string out = folder / "out", command = "demo " + (folder / "demo.lua") + " -o " + out;
  ASSERT_EQ(run(command).exit_code, 0);
  std::string picture = contentOf(out + "/a_card/hybrid.png");
  ASSERT_EQ(run(command + " --size 32x18").exit_code, 0);
  EXPECT_NE(contentOf(out + "/a_card/hybrid.png"), picture);
  ASSERT_EQ(run(command).exit_code, 0);
  EXPECT_EQ(contentOf(out + "/a_card/hybrid.png"), picture);
}

// ---- sweep

TEST(Sweep, FailedExpectationIsNamedAndGivesExitCodeOne) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  std::string wrong = "{ \"two is three\", function() return false, \"2 < 3\" end },";
  writeText(folder / "x.lua", demoText("hybrid", "", wrong));
  std::string out = folder / "out";
  Outcome outcome = run("sweep " + (folder / "x.lua") + " -o " + out + " --json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("strobe: expectation fails: two is three (2 < 3)"), std::string::npos) << outcome.err;
  for (const char* file : {"report.html", "report.png", "result.json", "result.md", "table.csv"})
    EXPECT_TRUE(fs::exists(out + "/" + file)) << file;
  EXPECT_GT(image::readPng(out + "/report.png").width, 3 * 64 * 7) << "a column for each shown arm";
  EXPECT_EQ(Json::parse(outcome.out), Json::parse(contentOf(out + "/result.json")));
  EXPECT_NE(contentOf(out + "/result.md").find("two is three. This fails"), std::string::npos);

  // `report` uses the texts and expectations of the current file.
  std::string known = replaced(wrong, "end }", "end, known = \"two is two\" }");
  writeText(folder / "x.lua", demoText("hybrid", "", known));
  EXPECT_EQ(run("report " + out).exit_code, 1);
  EXPECT_EQ(run("report " + out + " --experiment " + (folder / "x.lua")).exit_code, 0);

  // The printed command of a point draws the point's picture.
  Json point = Json::parse(contentOf(out + "/result.json"))["groups"][0]["points"][1];
  std::string repeat = point["command"].get<std::string>();
  repeat = repeat.substr(7, repeat.find(" -o ") - 7);
  ASSERT_EQ(run(repeat + " -o " + (folder / "point.exr")).exit_code, 0) << repeat;
  Json record = Json::parse(contentOf(out + "/" + point["record"].get<std::string>()));
  EXPECT_EQ(Json::parse(contentOf(folder / "point.record.json"))["outputs"], record["outputs"]);
}

TEST(Sweep, ListsItsPointsAndRefusesOthers) {
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  writeText(folder / "x.lua", demoText("hybrid", ""));
  std::string command = "sweep " + (folder / "x.lua") + " -o " + (folder / "out");
  Outcome listed = run(command + " --dry-run");
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_NE(listed.out.find("1  card  no blur\n"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find("6 points, 2 truths"), std::string::npos) << listed.out;
  EXPECT_EQ(Json::parse(run(command + " --dry-run --json").out).size(), 6u);
  auto refused = [](const std::string& arguments, const std::string& wanted) {
    Outcome outcome = run(arguments, "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused(command + " --only arm=hybird", "did you mean 'hybrid'?");
  refused(command + " --size 3", "WIDTHxHEIGHT");
  refused("sweep " + (folder / "x.lua") + " -o /dev/null/x", "is not a folder");
  refused("report " + folder.path().string(), "no results in");
  refused("bench", "A subcommand is required");
  refused("bench relod hybrid", "unknown command 'relod' of bench; did you mean 'reload'?");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace sweep_test
}  // namespace strobe::testing
