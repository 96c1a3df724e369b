// SPDX-License-Identifier: MIT
// Measures of experiments: errors compared with closed forms, memory counted by hand, differences computed from the
// pictures, and expectations that must fail.
#include "study/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/frozen_home.h"
#include "base/inputs.h"
#include "oracle/render.h"
#include "program/run.h"

namespace strobe::study {
namespace run_test {

class Measuring : public oracle::RenderTest {
 protected:
  static Results measured(const std::string& text, double truth_error = 0) {
    testing::TemporaryFolder folder;
    testing::writeText(folder / "x.lua", text);
    Experiment experiment = readExperiment(bench().home(), folder / "x.lua");
    experiment.truth_error = truth_error;
    lab::Batch batch(bench());
    return run(experiment, batch, Store(folder.path()));
  }
};

// A white half-plane x < 80 that moves right over black. Only its edge blurs, so that a closed form is needed only for
// the edge.
const char* const kHalfPlane = R"lua(
local experiment = require "strobe.experiment"
local list = experiment.list
return experiment {
  title = "Half a plane", size = { 160, 4 }, size_params = { "width", "height" }, measures = { "rmse" },
  truth = { pipeline = "ground_truth", set = { samples = 512 } },
  arms = { { name = "no blur", pipeline = "none", lacks = { "samples" } },
           { name = "floor", pipeline = "ground_truth", role = "floor", set = { samples = 16 } } },
  shots = { { name = "plane", scene = "oracles/half_plane", frame = 0, ["scene.d_f"] = 12.7 } },
  vary = { experiment.each {
    list { name = "speed", values = { 5.3, 12.7, 31.9 }, scale = "log", benign = 12.7, region = "whole",
           at = function(v) return { ["scene.d_f"] = v } end },
    list { name = "samples", values = { 2, 8, 32 }, scale = "log", benign = 8, region = "inner" } } },
  layout = { curves = {} },
}
)lua";

// Truth of 512 midpoints has an error of at most 1 / (2 * 512) where one edge passes.
constexpr double kOfTruth = 0.5 / 512;

TEST_F(Measuring, ErrorsMatchTheClosedForm) {
  Results results = measured(kHalfPlane);
  ASSERT_EQ(results.groups.size(), 6u);
  for (size_t g = 0; g < 3; ++g) {
    double squares = 0, speed = results.groups[g].at[0].second.get<double>();
    for (int i = 0; i < 160; ++i) {
      double missed = (i + 0.5 < 80 ? 1 : 0) - oracle::halfPlaneAtCentre(80, speed, oracle::kCloseAnchor, i);
      squares += missed * missed;
    }
    EXPECT_NEAR(results.groups[g].find("no blur")->value("rmse"), std::sqrt(squares / 160), kOfTruth) << speed;
    EXPECT_EQ(results.groups[g].truth().value("change") == 0, speed == 12.7) << "change from the benign value";
  }

  // The floor of N midpoints against the exact exposure, for pixels of the inner blur only.
  const oracle::Strips plane = {{-oracle::kInfinity, 80, 12.7, {1}}, {-oracle::kInfinity, oracle::kInfinity, 0, {0}}};
  for (size_t g = 3; g < 6; ++g) {
    const PointGroup& group = results.groups[g];
    double squares = 0;
    int count = 0, samples = group.at[0].second.get<int>();
    for (int i = 67; i < 80; ++i) {
      double mean = 0;
      for (int m = 0; m < samples; ++m)
        mean += oracle::seenAt(plane, i + 0.5, (m + 0.5) / samples - 1).colour / samples;
      double off = mean - oracle::halfPlaneAtCentre(80, 12.7, oracle::kCloseAnchor, i);
      squares += off * off;
      ++count;
    }
    EXPECT_EQ(group.truth().value("pixels", "inner"), 4 * count) << "inner pixels: pixels that the edge passes";
    EXPECT_NEAR(group.floor()->value("rmse", "inner"), std::sqrt(squares / count), 2 * kOfTruth) << samples;
  }
  // The error is proportional to 1/N: 16 times as many samples have 1/16 of the error, up to the position of the edge.
  auto floor = [&](size_t g) { return results.groups[g].floor()->value("rmse", "inner"); };
  EXPECT_GT(floor(3) / floor(5), 16 / 1.5);
  EXPECT_LT(floor(3) / floor(5), 16 * 1.5);
  EXPECT_EQ(results.groups[3].find("no blur")->value("rmse"), results.groups[5].find("no blur")->value("rmse"))
      << "`no blur` has no parameter samples";
}

// Every file in the run record of a picture, and the experiment itself.
TEST_F(Measuring, InputsMatchTheRunRecords) {
  testing::TemporaryFolder folder;
  testing::writeText(folder / "x.lua", kHalfPlane);
  const Home& home = bench().home();
  lab::Batch batch(bench());
  Results results = run(readExperiment(home, folder / "x.lua"), batch, Store(folder.path()));
  EXPECT_EQ(results.inputs.at(folder / "x.lua"), inputHash(folder / "x.lua"));
  for (const char* pipeline : {"none", "ground_truth"}) {
    Json record = render(oracle::with(oracle::shotOf("half_plane", 160, 4), pipeline)).record;
    for (const char* part : {"scripts", "shaders"})
      for (const auto& [name, hash] : record.at(part).items()) {
        Path file = home.shipped() / name.substr(name.find(':') + 1);
        if (std::filesystem::is_regular_file(file)) EXPECT_EQ(results.inputs[name], inputHash(file)) << name;
      }
  }
  lab::Batch other(bench());
  other.contentOf(oracle::with(oracle::shotOf("half_plane", 160, 4), "mcguire2012"));
  EXPECT_TRUE(std::any_of(other.inputs().begin(), other.inputs().end(), [&](const Path& file) {
    return !results.inputs.count(home.recorded(file, ""));
  })) << "shaders of other pipelines are not inputs";
  EXPECT_EQ(resultsFrom(toJson(results), "x").inputs, results.inputs);
}

// A stored point stays valid if only comments change.
TEST_F(Measuring, KeysDoNotDependOnCommentsOfShaders) {
  testing::TemporaryFolder folder;
  FrozenHome copy(bench().home(), folder.path() / "home");
  const Path shader = copy.home().at("shaders/gather/mcguire2012.glsl");
  const std::string before = readText(shader);
  auto content = [&](const std::string& text) {
    testing::writeText(shader, text);
    lab::Workbench own(copy.home(), bench());
    return lab::Batch(own).contentOf(oracle::with(oracle::shotOf("half_plane", 160, 4), "mcguire2012"));
  };
  const std::string key = content(before);
  EXPECT_EQ(content("// Another line.\n" + before + "/* and\n   another */\n"), key);
  EXPECT_NE(content(before + "const int another = 1;\n"), key);
}

// A bar from x = 16 to 32 that moves by 6 px over the exposure.
const char* const kRegions = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Regions", size = { 48, 24 }, rounds = 3, most_rounds = 12, within = 0.01, base = "again",
  size_params = { "width", "height" },
  measures = { "rmse", "pixels", "p999", "psnr", "ssim", "smape", "relmse", "ms", "ms_low", "ms_high", "ms_ratio" },
  regions = { "whole", "moving", "edge" },
  truth = { pipeline = "ground_truth", set = { samples = 64 } },
  arms = { { name = "none", pipeline = "none" }, { name = "again", pipeline = "none" },
           { name = "few", pipeline = "ground_truth", set = { samples = 2 } },
           { name = "few, timed", pipeline = "ground_truth", timed = true, set = { samples = 3 } },
           { name = "never", pipeline = "mcguire2012", timed = false } },
  shots = { { name = "bar", scene = "oracles/bar", frame = 0, ["scene.d_f"] = 6, ["scene.left"] = 16, ["scene.right"] = 32 } },
}
)lua";

TEST_F(Measuring, HasRegionsAndTimeRatios) {
  Results results = measured(kRegions);
  const Point& none = results.groups.at(0).points.at(1);
  EXPECT_EQ(none.value("pixels", "whole"), 48 * 24);
  EXPECT_EQ(none.value("pixels", "moving"), 16 * 24) << "the bar from 16 to 32";
  EXPECT_EQ(none.value("pixels", "edge"), 2 * 4 * 24) << "two pixels to each side of its two edges";
  EXPECT_EQ(none.value("rmse", "whole"), none.value("rmse"));
  EXPECT_GT(none.value("p999", "whole"), none.value("rmse", "whole"));
  EXPECT_LT(none.value("psnr", "edge"), none.value("psnr", "whole")) << "errors lie at the edges";
  EXPECT_LT(none.value("ssim", "edge"), none.value("ssim", "whole"));
  EXPECT_GT(none.value("smape", "edge"), none.value("smape", "whole"));
  EXPECT_GT(none.value("relmse", "edge"), none.value("relmse", "whole"));
  EXPECT_LE(none.value("ms_low"), none.value("ms"));
  EXPECT_GE(none.value("ms_high"), none.value("ms"));
  EXPECT_GT(none.value("ms_ratio"), 0);
  EXPECT_GT(results.groups[0].points[2].value("ms_ratio"), 0) << "the base is measured too";
  EXPECT_EQ(none.image, results.groups[0].points[2].image);
  EXPECT_TRUE(std::isnan(results.groups[0].points[3].value("ms"))) << "truth has no times";
  EXPECT_GT(results.groups[0].points[4].value("ms"), 0) << "an arm that requests times";
  EXPECT_TRUE(std::isnan(results.groups[0].points[5].value("ms")));
}

// The same bar from frame to frame: arm `none` jumps by whole displacements where truth has ramps.
const char* const kSequence = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Sequence", size = { 160, 4 }, size_params = { "width", "height" }, regions = { "whole" },
  measures = { "rmse", "flicker", "rays", "masked" },
  truth = { pipeline = "ground_truth", set = { samples = 512 } },
  arms = { { name = "none", pipeline = "none" }, { name = "hybrid", pipeline = "hybrid" } },
  shots = { { name = "plane", scene = "oracles/half_plane", frames = { 0, 2, 1 }, ["scene.d_f"] = 12.7 } },
}
)lua";

TEST_F(Measuring, FlickerOfSequencesMatchesTheClosedForm) {
  Results results = measured(kSequence);
  const Point& none = results.groups.at(0).points.at(1);
  // With an exposure of half a frame interval, 12.7 px per exposure are 25.4 px per frame.
  auto edge = [](int frame) { return 80 + 25.4 * frame; };
  double squares = 0, flicker = 0;
  for (int frame = 0; frame < 3; ++frame) {
    double sum = 0;
    for (int i = 0; i < 160; ++i) {
      auto off = [&](int at) {
        return (i + 0.5 < edge(at) ? 1 : 0) - oracle::halfPlaneAtCentre(edge(at), 12.7, oracle::kCloseAnchor, i);
      };
      sum += off(frame) * off(frame);
      if (frame > 0) flicker += std::abs(off(frame) - off(frame - 1)) / 160 / 2;
    }
    squares += std::sqrt(sum / 160) / 3;
  }
  EXPECT_NEAR(none.value("rmse"), squares, kOfTruth) << "mean over the frames";
  EXPECT_NEAR(none.value("flicker"), flicker, 2 * kOfTruth);

  // Every masked pixel has a ray, and this flat scene casts no shadows.
  const Point& hybrid = results.groups[0].points[2];
  EXPECT_GT(hybrid.value("masked"), 0);
  EXPECT_GE(hybrid.value("rays"), hybrid.value("masked"));
  EXPECT_TRUE(std::isnan(none.value("masked"))) << "the arm has no mask";
  EXPECT_LT(hybrid.value("flicker"), none.value("flicker"));
}

const char* const kCoarse = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Coarse", size = { 48, 24 }, regions = { "whole" }, measures = { "rmse" },
  truth = { pipeline = "ground_truth", set = { samples = 4, times = "stratified" } },
  arms = { { name = "none", pipeline = "none" } },
  shots = { { name = "bar", scene = "oracles/bar", ["scene.d_f"] = 6 } },
}
)lua";

TEST_F(Measuring, TruthTakesSamplesUntilItsErrorIsSmall) {
  Results coarse = measured(kCoarse);
  const PointGroup& group = coarse.groups.at(0);
  double error = group.truth().value("rmse");

  Results finer = measured(kCoarse, error / 8);
  EXPECT_LE(finer.groups.at(0).truth().value("rmse"), error / 8);
  EXPECT_NE(finer.groups[0].truth().command, group.truth().command) << "the command includes the samples";

  // The maximum is 65536 samples; with this tolerance truth takes only a few samples.
  std::string most = kCoarse;
  most.replace(most.find("samples = 4"), 11, "samples = 65536, tolerance = 1");
  Results refused = measured(most, 1e-12);
  EXPECT_NE(refused.groups.at(0).points[1].failed.find("with its maximum of"), std::string::npos);
}

// Bytes of formats can be counted; differences are computed from the pictures.
const char* const kFormats = R"lua(
local experiment = require "strobe.experiment"
local list = experiment.list
return experiment {
  title = "Formats", size = { 48, 8 }, size_params = { "width", "height" }, rounds = 2,
  measures = { "rmse", "bytes", "memory", "change", "change_rms", "ms" }, regions = { "whole" },
  truth = { pipeline = "mcguire2012", set = { limit = 10, color_format = "fp16" } },
  arms = { { name = "blur", pipeline = "mcguire2012", set = { limit = 10 } } },
  shots = { { name = "bar", scene = "oracles/bar", frame = 0, ["scene.d_f"] = 5.03, ["scene.left"] = 16,
              ["scene.right"] = 32, ["scene.foreground"] = 70000 } },
  vary = { experiment.each { list { name = "velocity_format", values = { "fp32", "fp16" }, benign = "fp32" },
                             list { name = "color_format", values = { "fp32", "fp16" }, benign = "fp32" } } },
  expect = {
    { "half floats are smaller", function(r)
      return r.at { color_format = "fp16" }.bytes < r.at { color_format = "fp32" }.bytes
    end },
    { "they change nothing", function(r) return r.at { color_format = "fp16" }.change == 0, "as was said" end },
    { "what was not measured", function(r) return r.at {}.flip < 1 end },
    { "what does not apply", function() return nil end },
  },
}
)lua";

TEST_F(Measuring, HasBytesDifferencesAndLimits) {
  Results results = measured(kFormats);
  ASSERT_EQ(results.groups.size(), 4u);
  auto value = [&](size_t g, const std::string& measure) { return results.groups[g].points[1].value(measure); };
  EXPECT_EQ(value(1, "bytes"), value(0, "bytes") - 4);  // rg32f to rg16f
  EXPECT_EQ(value(3, "bytes"), value(2, "bytes") - 8);  // rgba32f to rgba16f
  EXPECT_NEAR(value(0, "memory"), value(0, "bytes") * 48 * 8 / (1 << 20), 1e-9) << "nine digits are stored";
  EXPECT_EQ(value(0, "change"), 0);
  EXPECT_NEAR(value(3, "change"), 70000 - 65504, 0.1);  // inside the bar, a sum of 16 taps in fp32
  EXPECT_EQ(value(3, "rmse"), 0) << "this arm is truth here";
  EXPECT_EQ(value(2, "rmse"), value(3, "change_rms")) << "compares the same two pictures";
  ASSERT_EQ(results.groups[3].points[1].limits.size(), 1u);
  EXPECT_NE(results.groups[3].points[1].limits[0].find(fmt::format("{}", 16 * 8)), std::string::npos);
  for (size_t g = 0; g < 4; ++g) EXPECT_GT(value(g, "ms"), 0);

  std::vector<std::string> outcomes;
  for (const Expectation& one : results.expectations) outcomes.push_back(one.outcome);
  EXPECT_EQ(outcomes, (std::vector<std::string>{"holds", "fails", "fails", "does not apply"}));
  EXPECT_EQ(results.expectations[1].detail, "as was said");
  EXPECT_NE(results.expectations[2].detail.find("no value of 'flip' was measured"), std::string::npos);
}

}  // namespace run_test
}  // namespace strobe::study
