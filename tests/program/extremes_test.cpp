// SPDX-License-Identifier: MIT
// `strobe bench --extremes` from outside: what it writes, that a rerun writes the same, what it refuses.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace {

// SET and MORE stand for fields of a method and of the axis.
const char* const kExperiment = R"lua(
local extremes = require "strobe.extremes"
return extremes {
  title = "A bar", size = { 64, 16 }, size_params = { "width", "height" }, factor = 2,
  truth = { label = "truth", pipeline = "ground_truth", set = { samples = 32, times = "stratified" } },
  floor = { label = "floor", pipeline = "ground_truth", set = { samples = 16 } },
  methods = {
    { label = "no blur", pipeline = "none" },
    { label = "hybrid", pipeline = "hybrid", METHOD },
  },
  axes = {
    { name = "speed", title = "Speed", unit = "px", scale = "log", values = { 4.7, 30 }, benign = 4.7, region = "inner",
      scene = "oracles/bar", fixed = "A bar.", AXIS,
      at = function(v) return { scene = { left = 20, right = 50, d_f = v }, POINT } end },
  },
}
)lua";

std::string textWith(const std::string& method, const std::string& axis = "", const std::string& point = "") {
  std::string text = kExperiment;
  for (const auto& [what, with] :
       {std::pair<std::string, std::string>{", METHOD", method}, {", AXIS", axis}, {", POINT", point}})
    text.replace(text.find(what), what.size(), with.empty() ? "" : ", " + with);
  return text;
}

void expectRefusal(const std::string& text, const std::string& wanted) {
  TemporaryFolder folder;
  writeText(folder / "x.lua", text);
  Outcome outcome =
      run("bench --extremes --file " + (folder / "x.lua") + " -o " + (folder / "out"), "STROBE_VALIDATION=0");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err << "expected: " << wanted;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Extremes, MistakesHaveTheirPlaceAndTheNearestName) {
  expectRefusal(textWith("sett = {}"), "x.lua:7: method 2 has no field 'sett'; did you mean 'set'?");
  expectRefusal(textWith("", "scale = \"lgo\""),
                "the scale of an axis is 'lgo', none of log, linear, even; did you mean 'log'?");
  expectRefusal(textWith("", "region = \"iner\""), "did you mean 'inner'?");
  expectRefusal(textWith("", "benign = 5"), "benign is 5, which is none of the values");
  expectRefusal(textWith("", "values = { 4.7, 2 }"), "values grow; 2 follows 4.7");
  expectRefusal(textWith("", "values = { -1, 4.7 }"), "-1 has no logarithm");
  expectRefusal(textWith("", "", "scne = {}"), "has no field 'scne'; did you mean 'scene'?");
  expectRefusal(textWith("", "", "set = { sampels = 4 }"), "did you mean 'samples'?");
  expectRefusal(textWith("", "", "shot = { exposre = 1 }"), "a shot has no option 'exposre'; did you mean 'exposure'?");
  expectRefusal(textWith("", "", "set = nothing.at_all"), "at(4.7) of axis 'speed' fails");
  expectRefusal(textWith("set = { preset = \"bset\" }"), "did you mean 'best'?");
  expectRefusal("return {}", "does not return extremes { ... }");
}

TEST(Extremes, CommandLinesAreRefused) {
  auto refused = [](const std::string& arguments, const std::string& wanted) {
    Outcome outcome = run(arguments, "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused("bench", "wants --extremes or a command: reload, values");
  refused("bench relod hybrid", "there is no command 'relod' of bench; did you mean 'reload'?");
  refused("bench --only speed", "--only requires --extremes");
  refused("bench --extremes --only sped", "did you mean 'speed'?");
  refused("bench --extremes --size 3", "WIDTHxHEIGHT");
  refused("bench --extremes --samples-of-truth 0", "not in range 1 to 65536");
  refused("bench --extremes -o /dev/null/x", "is not a folder");
  refused("bench --extremes reload none", "excludes --extremes");
}

TEST(Extremes, WritesPageAndNumbersTwiceTheSame) {
  TemporaryFolder folder;
  writeText(folder / "x.lua", textWith("set = { limit = 0.3 }", "reading = \"{hybrid @ 4.7}\""));
  std::string command = "bench --extremes --file " + (folder / "x.lua") + " -o ";
  Outcome first = run(command + (folder / "a.html") + " --markdown " + (folder / "a.md"));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.err.find("2/2  speed 30"), std::string::npos) << first.err;
  Json report = Json::parse(contentOf(folder / "a.json"));
  const Json& points = report["axes"][0]["points"];
  ASSERT_EQ(points.size(), 2u);
  EXPECT_FALSE(points[0]["methods"][1].contains("limits"));
  EXPECT_NE(points[1]["methods"][1]["limits"].dump().find("farther than the limit"), std::string::npos)
      << "30 px are more than 0.3 of 64";
  EXPECT_LT(points[0]["methods"][1]["rmse"][1].get<double>(), 0.5 * points[0]["methods"][0]["rmse"][1].get<double>());
  EXPECT_NE(contentOf(folder / "a.html").find("class=\"hollow\""), std::string::npos);
  EXPECT_EQ(contentOf(folder / "a.md").find("{hybrid"), std::string::npos);

  // The command it prints for a point makes that picture.
  std::string repeat = points[0]["methods"][1]["command"].get<std::string>();
  ASSERT_EQ(repeat.find("strobe render hybrid --scene oracles/bar"), 0u) << repeat;
  repeat = repeat.substr(7, repeat.find(" -o ") - 7);
  EXPECT_EQ(run(repeat + " -o " + (folder / "point.exr")).exit_code, 0) << repeat;

  Outcome second = run(command + (folder / "b") + " --json");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  Json again = Json::parse(contentOf(folder / "b/extremes.json"));
  EXPECT_EQ(Json::parse(second.out), again);
  again["command"] = report["command"];
  EXPECT_EQ(again, report);

  Outcome laid_out = run(command + (folder / "c.html") + " --from " + (folder / "a.json"));
  ASSERT_EQ(laid_out.exit_code, 0) << laid_out.err;
  EXPECT_EQ(contentOf(folder / "c.html"), contentOf(folder / "a.html"));
}

}  // namespace
}  // namespace strobe::testing
