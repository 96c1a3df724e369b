// SPDX-License-Identifier: MIT
// One bad pixel, one bad point: effect of a mistake in a pass of one arm on the picture, the sweep and its report.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace one_bad_point_test {

const char* const kExperiment = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "One bad", size = { 64, 36 }, measures = { "rmse", "flip", "psnr", "memory" }, regions = { "whole" },
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "smear", pipeline = "smear" }, { name = "none", pipeline = "none" } },
  truth = { pipeline = "ground_truth", set = { samples = 4 } },
  layout = { LAYOUT },
}
)lua";

// A project made by `strobe new`, with an experiment.
class OneBadPoint : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run("new '" + (folder_ / "p") + "'").exit_code, 0);
    fs::create_directories(folder_ / "p/experiments");
    layOut("pictures = {}");
  }

  void layOut(const std::string& layout) const {
    writeText(folder_ / "p/experiments/x.lua", std::regex_replace(kExperiment, std::regex("LAYOUT"), layout));
  }

  void replaceIn(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = contentOf(folder_ / ("p/" + file));
    size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " does not contain: " << from;
    writeText(folder_ / ("p/" + file), text.replace(at, from.size(), to));
  }

  // Sets the colour of some pixels to `bad`.
  void spoil(const std::string& where, const std::string& bad) const {
    replaceIn("shaders/smear.glsl", "vec4(mean, 1)",
              "vec4(" + where + " ? vec3(uintBitsToFloat(" + bad + "u)) : mean, 1)");
  }

  Outcome inside(const std::string& arguments) const {
    return runLine("cd '" + (folder_ / "p") + "' && exec env STROBE_VALIDATION=0 '" + programPath() + "' " + arguments);
  }
  std::string file(const std::string& name) const { return contentOf(folder_ / ("p/" + name)); }

  TemporaryFolder folder_;
};

const std::string kNan = "0x7fc00000", kInfinity = "0x7f800000";

TEST_F(OneBadPoint, NotFiniteIsWarnedAbout) {
  spoil("pixel == ivec2(3) || pixel == ivec2(5, 9)", kNan);
  Outcome outcome = inside("render smear --scene oracles/bar --size 64x36 -o a.exr");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("color: 2 of 2304 pixels are not finite, the first at 3,3 (nan)"), std::string::npos)
      << outcome.err;
  EXPECT_NE(Json::parse(file("a.record.json"))["warnings"].dump().find("the first at 3,3"), std::string::npos);
}

// A pixel that is not finite leaves the values of its arm empty and states the reason; all other values are complete.
TEST_F(OneBadPoint, IsFlaggedAndOtherPointsAreComplete) {
  for (const std::string& bad : {kNan, kInfinity}) {
    const fs::path shader = folder_ / "p/shaders/smear.glsl";
    const std::string sound = contentOf(shader);
    spoil("pixel == ivec2(3)", bad);
    Outcome outcome = inside("sweep experiments/x.lua -o out");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("color: 1 of 2304 pixels is not finite, the first at 3,3"), std::string::npos);
    const std::string table = file("out/table.csv");
    EXPECT_TRUE(std::regex_search(table, std::regex("\n1,smear,bar,whole,,,,[0-9.]+,[0-9.]+,smear,,1 px not finite\n")))
        << table;
    EXPECT_TRUE(
        std::regex_search(table, std::regex("\n2,none,bar,whole,[0-9.e-]+,[0-9.e-]+,[0-9.]+,[0-9.]+,[0-9.]+,none,,\n")))
        << table;
    EXPECT_NE(file("out/result.md").find("| 1 px not finite |"), std::string::npos) << file("out/result.md");
    EXPECT_TRUE(fs::exists(folder_ / "p/out/report.png"));
    EXPECT_NE(file("out/report.html").find("1 px not finite"), std::string::npos);
    EXPECT_EQ(inside("report out").exit_code, 0);
    writeText(shader, sound);
  }
}

TEST_F(OneBadPoint, IsFlaggedInATable) {
  layOut("");
  spoil("pixel == ivec2(3)", kNan);
  Outcome outcome = inside("sweep experiments/x.lua -o out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(std::regex_search(outcome.out, std::regex("smear +1 px not finite"))) << outcome.out;
}

// The picture of a pipeline must be as large as the frame.
TEST_F(OneBadPoint, OfAnotherSizeIsRefused) {
  replaceIn("passes/smear.lua", "{ of = \"color\" }", "{ 32, 32 }");
  const std::string said =
      "passes/smear.lua:8: output 'color' of pipeline 'smear' is 'smear.color', which is 32x32 in a frame of 64x36";
  for (const char* command : {"check smear", "render smear --scene oracles/bar --size 64x36 -o x.png"}) {
    Outcome outcome = inside(command);
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  // In a sweep, the other points are drawn.
  Outcome outcome = inside("sweep experiments/x.lua -o out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  const std::string table = file("out/table.csv");
  EXPECT_TRUE(
      std::regex_search(table, std::regex("\n1,smear,bar,whole,,,,,[0-9.]+,smear,,\"?failed: passes/smear.lua:8: ")))
      << table;
  EXPECT_TRUE(std::regex_search(table, std::regex("\n2,none,bar,whole,[0-9.e-]+,"))) << table;
}

}  // namespace one_bad_point_test
}  // namespace strobe::testing
