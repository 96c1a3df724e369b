// SPDX-License-Identifier: MIT
// Truth in steps compared with truth in one run.
#include "lab/running_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lab/capture.h"
#include "oracle/render.h"

using namespace strobe;
using namespace strobe::lab;

namespace running_truth_test {

class RunningTruthTest : public oracle::RenderTest {
 protected:
  // An edge that moves by 20 px over the exposure, in the middle of a width of 48 px.
  static Shot shot() { return oracle::shotOf("half_plane", 48, 4, {{"edge", 24}, {"d_f", 20}}); }

  static void take(RunningTruth& truth, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(truth.step());
  }
};

// The standard error estimated from the steps is within a factor of 3 of the error against 512 samples in one run
// (whose own error is at most 1/512).
TEST_F(RunningTruthTest, ErrorMatchesItsEstimate) {
  image::Image reference =
      lab::colorOf(render(oracle::with(shot(), "ground_truth", {"samples=512", "mark_regions=false"})));
  RunningTruth truth(bench(), "ground_truth", {4, 4});
  truth.restart(shot());
  EXPECT_TRUE(std::isinf(truth.standardError()));
  double before = 1;
  for (int steps : {2, 8, 24}) {
    take(truth, steps - truth.samples() / 4);
    double error = oracle::rmsDifference(truth.mean(), reference);
    EXPECT_LE(error, 3 * truth.standardError()) << steps;
    EXPECT_GE(error, truth.standardError() / 3) << steps;
    EXPECT_LT(truth.standardError(), before);
    before = truth.standardError();
  }
  EXPECT_EQ(truth.samples(), 96);
}

// A step has as many samples as all steps before it, up to a maximum: samples over more strata have a smaller error.
TEST_F(RunningTruthTest, StepsGrow) {
  const double always = std::numeric_limits<double>::infinity();
  image::Image reference =
      lab::colorOf(render(oracle::with(shot(), "ground_truth", {"samples=512", "mark_regions=false"})));
  RunningTruth growing(bench(), "ground_truth", {2, 16, always}), even(bench(), "ground_truth", {2, 2});
  growing.restart(shot());
  even.restart(shot());
  std::vector<int> samples;
  for (int i = 0; i < 6; ++i) {
    take(growing, 1);
    samples.push_back(growing.samples());
  }
  EXPECT_EQ(samples, (std::vector<int>{2, 4, 8, 16, 32, 48}));
  take(even, 24);
  EXPECT_EQ(even.samples(), 48);
  double error = oracle::rmsDifference(growing.mean(), reference);
  EXPECT_LT(error, oracle::rmsDifference(even.mean(), reference) / 2);
  EXPECT_LE(error, 3 * growing.standardError());
  growing.restart(shot());
  take(growing, 1);
  EXPECT_EQ(growing.samples(), 2) << "the first step is small again";

  RunningTruth slow(bench(), "ground_truth", {2, 16, 0});
  slow.restart(shot());
  take(slow, 4);
  EXPECT_EQ(slow.samples(), 8) << "with a limit of 0 s, steps do not grow";
}

// A step interrupted between two samples is dropped without an effect on the other steps.
TEST_F(RunningTruthTest, StepsAreInterruptedBetweenSamples) {
  RunningTruth truth(bench(), "ground_truth", {8, 8}), undisturbed(bench(), "ground_truth", {4, 4});
  truth.restart(shot());
  undisturbed.restart(shot());
  int samples = 0;
  EXPECT_TRUE(truth.step(8, [&] { return ++samples < 3; }));
  EXPECT_EQ(samples, 3);
  EXPECT_EQ(truth.samples(), 0);
  EXPECT_EQ(truth.interrupted(), 1);
  EXPECT_TRUE(truth.mean().empty());
  take(truth, 1);
  take(undisturbed, 1);
  EXPECT_EQ(truth.samples(), 4) << "half of the first step";
  EXPECT_TRUE(oracle::identical(truth.mean(), undisturbed.mean()));
  take(truth, 1);
  EXPECT_EQ(truth.samples(), 8);
  take(truth, 1);
  EXPECT_EQ(truth.samples(), 16) << "the step size is 8 again";
}

// A total is reached exactly, with any steps.
TEST_F(RunningTruthTest, StopsAtTheTotal) {
  RunningTruth truth(bench(), "ground_truth", {4, 16, std::numeric_limits<double>::infinity()});
  truth.restart(shot());
  while (truth.step(27 - truth.samples())) EXPECT_LE(truth.samples(), 27);
  EXPECT_EQ(truth.samples(), 27);
}

TEST_F(RunningTruthTest, RestartDropsAllSteps) {
  RunningTruth truth(bench(), "ground_truth", {2, 2});
  EXPECT_FALSE(truth.step()) << "no shot yet";
  truth.restart(shot());
  take(truth, 3);
  image::Image first = truth.mean();
  Shot other = shot();
  other.anchor = "start";
  truth.restart(other);
  EXPECT_EQ(truth.samples(), 0);
  EXPECT_TRUE(truth.mean().empty());
  take(truth, 3);
  EXPECT_FALSE(oracle::identical(truth.mean(), first));
  truth.restart(shot());
  take(truth, 3);
  EXPECT_TRUE(oracle::identical(truth.mean(), first)) << "equal steps give equal bits";
}

// The shot's seed changes the steps; steps differ from each other.
TEST_F(RunningTruthTest, StepsHaveDifferentSeeds) {
  RunningTruth truth(bench(), "ground_truth", {1, 1});
  truth.restart(shot());
  take(truth, 1);
  image::Image one = truth.mean();
  take(truth, 1);
  EXPECT_FALSE(oracle::identical(truth.mean(), one));
  EXPECT_GT(truth.standardError(), 0);
  Shot seeded = shot();
  seeded.seed = 7;
  truth.restart(seeded);
  take(truth, 1);
  EXPECT_FALSE(oracle::identical(truth.mean(), one));
}

// Truth ignores the settings of the pipeline on display.
TEST_F(RunningTruthTest, IgnoresSettingsOfOtherPipelines) {
  RunningTruth truth(bench(), "ground_truth", {1, 1});
  truth.restart(oracle::with(shot(), "hybrid", {}));
  take(truth, 1);
  EXPECT_EQ(truth.samples(), 1);
}

}  // namespace running_truth_test
