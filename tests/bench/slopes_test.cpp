// SPDX-License-Identifier: MIT
// Lines fitted through given times, their expected growth, and the least times of a GPU.
#include "bench/slopes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "bench/slopes_report.h"

namespace strobe::bench::test {
namespace slopes_test {

// Milliseconds of a pass at the axis value x.
using PassMs = double (*)(double x);

ShotTimes shotAt(double x, const std::vector<std::pair<std::string, PassMs>>& passes) {
  ShotTimes shot{"room", "blurred", 64, 36, {}, std::vector<double>(7, 0.5), {}};
  for (const auto& [name, ms] : passes) {
    shot.passes.push_back({name, std::vector<double>(7, ms(x)), 1, 100, 200, 7});
    for (double& frame : shot.ms) frame += ms(x);
  }
  return shot;
}

// Three passes whose names describe their growth, and `falls`, which decreases.
AxisRun axisOf(std::vector<ExpectedGrowth> expected) {
  AxisRun axis{"lights", "Lights", "", {}, {1, 2, 4, 8, 16}, std::move(expected)};
  axis.run = {"strobe bench slopes", "1.0", "hash", "a device", "a driver", "query", false, 4, {}, {}};
  for (double x : axis.x)
    axis.run.shots.push_back(shotAt(x, {{"same", [](double) { return 3.0; }},
                                        {"line", [](double at) { return 2 + 0.25 * at; }},
                                        {"tree", [](double at) { return 1 + 0.5 * std::log2(at); }},
                                        {"falls", [](double at) { return 20 - at; }}}));
  return axis;
}

const Fit& fitOf(const std::vector<Fit>& fits, const std::string& part) {
  return *std::find_if(fits.begin(), fits.end(), [&](const Fit& fit) { return fit.part == part; });
}

TEST(Slopes, FitTheTimes) {
  std::vector<Fit> fits = fitsOf(axisOf({{"tree", "", Growth::logarithmic, ""}}));
  ASSERT_EQ(fits.size(), 6u) << "the frame, four passes, the rest";
  EXPECT_EQ(fits.front().part, kFrame);
  EXPECT_EQ(fits.back().part, kRest);
  EXPECT_NEAR(fitOf(fits, "line").line.slope.value, 0.25, 1e-12);
  EXPECT_NEAR(fitOf(fits, "line").line.intercept, 2, 1e-12);
  EXPECT_NEAR(fitOf(fits, "line").line.r2, 1, 1e-12);
  const Fit& tree = fitOf(fits, "tree");
  EXPECT_NEAR(tree.line.slope.value, 0.5, 1e-12) << "per doubling";
  EXPECT_NEAR(tree.at(32), 3.5, 1e-12);
  EXPECT_NEAR(fitOf(fits, kRest).line.intercept, 0.5, 1e-9);
}

TEST(Slopes, AreComparedWithTheExpectedGrowth) {
  auto outcome = [](const std::string& part, Growth growth) {
    return fitOf(fitsOf(axisOf({{part, "blurred", growth, ""}})), part).verdict;
  };
  EXPECT_EQ(outcome("same", Growth::constant), GrowthVerdict::holds);
  EXPECT_EQ(outcome("same", Growth::linear), GrowthVerdict::fails);
  EXPECT_EQ(outcome("line", Growth::linear), GrowthVerdict::holds);
  EXPECT_EQ(outcome("line", Growth::constant), GrowthVerdict::fails);
  EXPECT_EQ(outcome("tree", Growth::logarithmic), GrowthVerdict::holds);
  EXPECT_EQ(outcome("tree", Growth::linear), GrowthVerdict::fails) << "R2 is 0.87 over x";
  EXPECT_EQ(outcome("falls", Growth::linear), GrowthVerdict::fails) << "a decreasing time does not grow";
}

// An expectation for every pass applies to passes without an expectation of their own.
TEST(Slopes, MostSpecificExpectationCounts) {
  std::vector<Fit> fits = fitsOf(axisOf({{kEveryPass, "", Growth::constant, ""},
                                         {"line", "", Growth::linear, ""},
                                         {kFrame, "other", Growth::linear, ""},
                                         {kFrame, "blurred", Growth::constant, "some reason"}}));
  EXPECT_EQ(fitOf(fits, "same").verdict, GrowthVerdict::holds);
  EXPECT_EQ(fitOf(fits, "line").verdict, GrowthVerdict::holds);
  EXPECT_EQ(fitOf(fits, "falls").verdict, GrowthVerdict::fails);
  EXPECT_EQ(fitOf(fits, kFrame).expected->why, "some reason");
  EXPECT_FALSE(fitOf(fits, kRest).expected) << "the rest is not a pass";
}

TEST(Slopes, TooFewValuesGiveNoFit) {
  AxisRun axis = axisOf({{"line", "", Growth::linear, ""}});
  axis.run.shots.resize(2), axis.x.resize(2);
  EXPECT_EQ(fitOf(fitsOf(axis), "line").verdict, GrowthVerdict::unknown);
}

TEST(Slopes, ExpectationForAnUnknownPartIsRefused) {
  try {
    AxisRun axis = axisOf({{"line", "", Growth::linear, ""}, {"lime", "", Growth::linear, ""}});
    requireKnownParts(axis, fitsOf(axis));
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no frame has the part 'lime'"), std::string::npos) << error.what();
    EXPECT_EQ(error.exitCode(), 2);
  }
}

// At 500 GB/s 1 GB takes 2 ms, at 10 billion rays per second 40 million take 4 ms. The first pass waits for its bytes
// (2 of 1 ms), the second for its rays (4 of 1 ms).
TEST(Demand, EachPassIsBoundByBytesOrRays) {
  Demand demand{"room", "blurred", 1920, 1080, {}, 0, ""};
  demand.passes = {{"gather", {}, 1, 600'000'000, 400'000'000, 10'000'000},
                   {"trace", {}, 1, 0, 500'000'000, 40'000'000}};
  EXPECT_EQ(bytesOf(demand.passes), 1'500'000'000u);
  EXPECT_EQ(raysOf(demand.passes), 50'000'000u);
  EXPECT_NEAR(demand.leastMs({500, 10}), 6, 1e-12);
  EXPECT_NEAR(demand.leastMs({1e9, 10}), 5, 1e-5) << "rays alone";
  EXPECT_NEAR(toJson(demand, {500, 10})["most_fps"].get<double>(), 1000.0 / 6, 1e-9);
}

TEST(SlopesReport, ShowsExpectedAndPublishedGrowth) {
  Slopes slopes{"strobe bench slopes", "Costs", "What?", {axisOf({{"line", "", Growth::linear, "a ray for each"}})}};
  slopes.fits = {fitsOf(slopes.axes[0])};
  slopes.gpu = {500, 10};
  slopes.demands = {{"room", "blurred", 1920, 1080, {{"gather", {}, 1, 0, 1'000'000'000, 0}}, 250, "somebody"}};
  std::string text = textOf(slopes), page = page::htmlOf(pageOf(slopes));
  for (const char* wanted : {"a ray for each", "holds", "250 µs", "somebody", "not a prediction", "1000.0 MB"}) {
    EXPECT_NE(text.find(wanted), std::string::npos) << wanted << "\n" << text;
    EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
  }
  EXPECT_EQ(text.find("falls"), std::string::npos) << "only passes with an expectation are listed";
  EXPECT_NE(page.find("falls"), std::string::npos);
  Json json = toJson(slopes);
  EXPECT_EQ(json["axes"][0]["fits"].size(), 6u);
  EXPECT_EQ(json["axes"][0]["fits"][2]["outcome"], "holds");
  EXPECT_EQ(json["demands"][0]["published"]["fps"], 250);
}

}  // namespace slopes_test
}  // namespace strobe::bench::test
