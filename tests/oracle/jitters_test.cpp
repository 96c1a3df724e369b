// SPDX-License-Identifier: MIT
// What the jitters promise, on the definitions that render_gathers_test.cpp holds the renderer to.
#include "oracle/jitters.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace strobe::oracle {
namespace jitters_test {

// Values published with the formula, for integer pixels.
TEST(Jitters, InterleavedGradientNoiseHasItsPublishedValues) {
  const std::array<std::array<double, 3>, 5> table = {
      {{1, 0, .555713}, {0, 1, .309269}, {1, 1, .864983}, {7, 3, .817801}, {100, 200, .544752}}};
  for (const auto& [x, y, value] : table) EXPECT_NEAR(ignJitter(int(x), int(y)) + 0.5, value, 5e-7) << x << " " << y;
}

// 256 x 256 pixels, 16 bins of 4096. The mean of white noise has a standard error of 0.29 / 256 = .0011, a bin one of
// 62: five of them. Gradient noise is more even than that.
TEST(Jitters, AreUniformWithoutBias) {
  constexpr int kSide = 256;
  for (uint32_t frame : {0u, 7u}) {
    for (const auto& [name, jitter] : jittersOf(frame)) {
      std::array<int, 16> bins{};
      double sum = 0;
      for (int i = 0; i < kSide * kSide; ++i) {
        double value = jitter(i % kSide, i / kSide);
        ASSERT_GE(value, -0.5) << name;
        ASSERT_LT(value, 0.5) << name;
        sum += value;
        ++bins[size_t(16 * (value + 0.5))];
      }
      EXPECT_NEAR(sum / (kSide * kSide), 0, 5 * .0011) << name << " " << frame;
      for (int count : bins) EXPECT_NEAR(count, 4096, 5 * 62) << name << " " << frame;
    }
  }
}

// Mean power of a 64 x 64 patch at up to `highest` periods across it, of white noise 1.
double lowFrequencyPower(const JitterAt& jitter, int highest) {
  constexpr int kSide = 64;
  double power = 0, variance = 1.0 / 12;
  int count = 0;
  for (int v = 0; v <= highest; ++v) {
    for (int u = -highest; u <= highest; ++u) {
      if ((u == 0 && v == 0) || u * u + v * v > highest * highest) continue;
      std::complex<double> sum = 0;
      for (int i = 0; i < kSide * kSide; ++i) {
        double angle = -2 * std::numbers::pi * (u * (i % kSide) + v * (i / kSide)) / kSide;
        sum += jitter(i % kSide, i / kSide) * std::polar(1.0, angle);
      }
      power += std::norm(sum) / (kSide * kSide * variance);
      ++count;
    }
  }
  return power / count;
}

// Periods of 16 px and more. White noise is 1 up to the spread of a mean over 24 frequencies, 0.2. Gradient noise keeps
// a tenth: it has lines elsewhere.
TEST(Jitters, GradientNoiseHasLessLowFrequenciesThanWhite) {
  for (const auto& [name, jitter] : jittersOf()) {
    double power = lowFrequencyPower(jitter, 4);
    if (name == "hash") {
      EXPECT_NEAR(power, 1, 0.6) << name;
    } else {
      EXPECT_LT(power, 0.2) << name;
    }
  }
}

TEST(Jitters, FramesDifferByTheGoldenRatioOrAreDrawnAnew) {
  auto first = jittersOf(0), second = jittersOf(1);
  for (size_t k = 0; k < first.size(); ++k) {
    double change = second[k].second(5, 3) - first[k].second(5, 3);
    double golden = change - std::floor(change);
    if (first[k].first == "hash") {
      EXPECT_GT(std::abs(golden - .6180339887), 1e-3);
    } else {
      EXPECT_NEAR(golden, .6180339887, 1e-9) << first[k].first;
    }
  }
}

}  // namespace jitters_test
}  // namespace strobe::oracle
