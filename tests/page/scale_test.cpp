// SPDX-License-Identifier: MIT
// Positions of values along an axis, compared with closed forms.
#include "page/scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "page/number.h"

namespace strobe::page {
namespace scale_test {

std::vector<std::string> labelsOf(const Scale& scale) {
  std::vector<std::string> labels;
  for (const Tick& tick : scale.ticks())
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(Scale, LogarithmicScaleHasPositionsAndTicks) {
  Scale scale(Scale::Kind::log, {1e-6, 1, 1e6});
  EXPECT_DOUBLE_EQ(scale.at(1e-6), 0);
  EXPECT_DOUBLE_EQ(scale.at(1), 0.5);
  EXPECT_DOUBLE_EQ(scale.at(1000), 0.75);
  EXPECT_DOUBLE_EQ(scale.at(1e9), 1) << "clamped";
  std::vector<std::string> labels = labelsOf(scale);
  ASSERT_EQ(labels.size(), 13u);
  EXPECT_EQ(labels.front(), "10⁻⁶");
  EXPECT_EQ(labels[3], "0.001");
  EXPECT_EQ(labels[10], "10000");
  EXPECT_EQ(labels.back(), "10⁶");
}

TEST(Scale, SmallTicksLieAtTheirLogarithms) {
  for (const Tick& tick : Scale(Scale::Kind::log, {1, 1000}).ticks()) {
    double value = std::pow(10.0, 3 * tick.at), power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    EXPECT_NEAR(value / power, std::round(value / power), 1e-9);
    EXPECT_EQ(tick.label.empty(), std::round(value / power) != 1) << value;
  }
  EXPECT_EQ(labelsOf(Scale(Scale::Kind::log, {10, 100})), (std::vector<std::string>{"10", "20", "50", "100"}));
}

TEST(Scale, ZeroHasItsOwnPosition) {
  Scale scale(Scale::Kind::log, {0, 1, 100});
  EXPECT_TRUE(scale.hasZero());
  EXPECT_EQ(scale.at(0), 0);
  EXPECT_DOUBLE_EQ(scale.at(1), scale.gap());
  EXPECT_DOUBLE_EQ(scale.at(10), scale.gap() + (1 - scale.gap()) / 2);
  EXPECT_EQ(labelsOf(scale).front(), "0");
}

TEST(Scale, RoundedEndsAtOneOrThreeTimesAPowerOfTen) {
  Scale scale(Scale::Kind::log, {0.04, 25}, true);
  EXPECT_DOUBLE_EQ(scale.at(0.03), 0);
  EXPECT_DOUBLE_EQ(scale.at(30), 1);
  EXPECT_NEAR(scale.at(0.95), 0.5, 0.002);  // sqrt(0.03 * 30) = 0.949
}

TEST(Scale, LinearAndEvenScalesHavePositions) {
  Scale linear(Scale::Kind::linear, {0, 7.5, 90});
  EXPECT_DOUBLE_EQ(linear.at(22.5), 0.25);
  EXPECT_EQ(labelsOf(linear), (std::vector<std::string>{"0", "15", "30", "45", "60", "75", "90"}));
  Scale even(Scale::Kind::even, {0, 60, 89, 89.5, 89.9});
  EXPECT_DOUBLE_EQ(even.at(89), 0.5);
  EXPECT_EQ(labelsOf(even), (std::vector<std::string>{"0", "60", "89", "89.5", "89.9"}));
}

TEST(Scale, RoundedLinearEndsAtTicks) {
  Scale scale(Scale::Kind::linear, {-0.7, 7.2}, true);
  EXPECT_DOUBLE_EQ(scale.at(-1), 0);
  EXPECT_DOUBLE_EQ(scale.at(8), 1);
  EXPECT_DOUBLE_EQ(scale.at(3.5), 0.5);
  EXPECT_EQ(labelsOf(scale).front(), "-1");
  EXPECT_EQ(labelsOf(scale).back(), "8");
}

// n slots of width 1/n, each value at the centre of its slot.
TEST(Scale, SlotsShareTheAxis) {
  Scale slots(Scale::Kind::slots, {2, 0, 1, 3, 2});
  EXPECT_DOUBLE_EQ(slots.slot(), 0.25);
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(slots.at(i), (i + 0.5) / 4);
  EXPECT_EQ(Scale(Scale::Kind::even, {0, 1}).slot(), 0);
}

TEST(Scale, EqualOrNoValuesGiveAnAxis) {
  for (Scale::Kind kind : {Scale::Kind::log, Scale::Kind::linear, Scale::Kind::even, Scale::Kind::slots})
    for (const std::vector<double>& values : {std::vector<double>(), {3.0}, {3.0, 3.0}, {NAN, INFINITY}, {1e12}}) {
      Scale scale(kind, values, true);
      EXPECT_GE(scale.at(3), 0);
      EXPECT_LE(scale.at(3), 1);
      EXPECT_LE(scale.ticks().size(), 40u);
    }
}

TEST(Numbers, AreShownReadably) {
  EXPECT_EQ(shownNumber(0), "0");
  EXPECT_EQ(shownNumber(12.8), "12.8");
  EXPECT_EQ(shownNumber(1e7), "10⁷");
  EXPECT_EQ(shownNumber(3e-6), "3·10⁻⁶");
  EXPECT_EQ(shownError(0.012341), "0.01234");
  EXPECT_EQ(shownError(0.0000123), "0.000012");
  EXPECT_EQ(shownError(0.000000123), "1.2e-07");
  EXPECT_EQ(shownError(0), "0");
  EXPECT_EQ(shownError(NAN), "–");
  EXPECT_EQ(shownShare(0.012345), "1.23 %");
  EXPECT_EQ(shownShare(NAN), "–");
  EXPECT_EQ(shownMs(9.125), "9.12 ms");
  EXPECT_EQ(shownMs(12.7), "13 ms");
}

}  // namespace scale_test
}  // namespace strobe::page
