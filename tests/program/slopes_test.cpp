// SPDX-License-Identifier: MIT
// The command `strobe bench slopes` on a few small pictures: written files and refusals. No test depends on a time.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace slopes_test {

// Image sizes, and a moving object whose masked pixels are counted.
const std::string kExperiment = R"lua(
local experiment = require "strobe.experiment"
local list = experiment.list
return experiment {
  title = "A few", size = { 32, 18 }, rounds = 1,
  shots = { { name = "cards", scene = "cards" } },
  arms = { { name = "plain", pipeline = "none" },
           { name = "rays", pipeline = "hybrid", published = { fps = 205, shot = "cards", by = "a paper" } } },
  truth = { pipeline = "ground_truth", set = { samples = 1 } },
  vary = { experiment.each {
    list { name = "pixels", values = { 144, 576, 1296 }, costs = { { part = "frame", grows = "linear", why = "more" } },
           at = function(n) return { size = { math.tointeger(math.sqrt(n * 16 / 9)), math.tointeger(math.sqrt(n * 9 / 16)) } } end },
    list { name = "cover", values = { 0.2, 0.6 }, against = "masked",
           at = function(v) return { ["scene.cover"] = v } end } } }
}
)lua";

class BenchSlopes : public ::testing::Test {
 protected:
  Outcome slopes(const std::string& options) { return run("bench slopes " + options, "STROBE_VALIDATION=0"); }
  std::string fileWith(const std::string& from = "", const std::string& to = "") {
    std::string text = kExperiment;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    writeText(folder_ / "few.lua", text);
    return folder_ / "few.lua";
  }
  void expectRefusal(const std::string& options, int code, const std::string& wanted) {
    Outcome outcome = slopes(options);
    EXPECT_EQ(outcome.exit_code, code) << options;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << options;
  }
  TemporaryFolder folder_;
};

TEST_F(BenchSlopes, WritesFitsAndDemands) {
  Outcome outcome = slopes(fileWith() + " --bandwidth 100 -o " + (folder_ / "out"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Lower bound of a frame's GPU time"), std::string::npos) << outcome.out;
  Json json = Json::parse(contentOf(folder_ / "out/slopes.json"));
  ASSERT_EQ(json["axes"].size(), 2u);
  const Json &pixels = json["axes"][0], &cover = json["axes"][1];
  EXPECT_EQ(pixels["run"]["shots"].size(), 6u);
  EXPECT_EQ(pixels["fits"][0]["x"], Json({144.0, 576.0, 1296.0}));
  EXPECT_EQ(pixels["fits"][0]["expected"], "linear");
  EXPECT_EQ(pixels["run"]["shots"][5]["width"], 48);
  EXPECT_FALSE(cover["fits"][0].contains("outcome")) << "the axis has no expectation";
  EXPECT_GT(cover["fits"][0]["x"][1].get<double>(), cover["fits"][0]["x"][0].get<double>()) << "masked pixels";
  ASSERT_EQ(json["demands"].size(), 4u);
  const Json &full_hd = json["demands"][2], &uhd = json["demands"][3];
  EXPECT_EQ(uhd["width"], 3840);
  EXPECT_EQ(uhd["published"]["fps"], 205);
  EXPECT_NEAR(uhd["bytes"].get<double>() / full_hd["bytes"].get<double>(), 4, 0.01) << "except at borders of tiles";
  EXPECT_EQ(uhd["rays"].get<double>(), 4 * full_hd["rays"].get<double>());
  EXPECT_GT(full_hd["rays"].get<double>(), json["demands"][0]["rays"].get<double>())
      << "compared with rays for shadows only";
  std::string page = contentOf(folder_ / "out/index.html");
  for (const char* text : {"<svg", "205", "a paper", "All passes"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  for (const char* outside : {"src=\"http", "href=\"http", "@import"}) EXPECT_EQ(page.find(outside), std::string::npos);
}

TEST_F(BenchSlopes, RefusesMisuse) {
  expectRefusal("none.lua", 1, "none.lua");
  expectRefusal(fileWith() + " --only axis=pixels", 2, "axis");
  expectRefusal(fileWith() + " --bandwidth 0", 2, "'0' is not a number above 0");
  expectRefusal(fileWith() + " --size 32", 2, "--size '32' is not WIDTHxHEIGHT");
  expectRefusal(fileWith("\"linear\"", "\"liner\""), 1, "did you mean 'linear'?");
  expectRefusal(fileWith("\"masked\"", "\"mask\""), 1, "not one of masked, displacement; did you mean 'masked'?");
  expectRefusal(fileWith("part = \"frame\"", "part = \"fame\""), 2, "no frame has the part 'fame'");
  expectRefusal(fileWith("fps = 205, ", ""), 1, "'fps'");
  expectRefusal(fileWith("shot = \"cards\"", "shot = \"card\""), 1, "did you mean 'cards'?");
  expectRefusal(
      fileWith("vary = { experiment.each {", "vary = { experiment.grid { seed = { 1, 2 } }, experiment.each {"), 2,
      "one varied axis at a time");
}

}  // namespace slopes_test
}  // namespace strobe::testing
