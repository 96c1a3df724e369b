// SPDX-License-Identifier: MIT
// Values that a sweep gives to a control: suggested by its declaration, by a range, or listed.
#include "live/sweep_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace strobe::live {
namespace sweep_axis_test {

using plan::ParamDesc;
using plan::Value;

lab::Control number(ParamDesc::Type type, const Value& value, std::optional<double> min, std::optional<double> max) {
  lab::Control control;
  control.declaration.name.push_back('x');
  control.declaration.type = type;
  control.declaration.min = min;
  control.declaration.max = max;
  control.value = value;
  return control;
}

lab::Control whole(int64_t value, std::optional<double> min, std::optional<double> max) {
  return number(ParamDesc::Type::Int, value, min, max);
}

lab::Control real(double value, std::optional<double> min, std::optional<double> max) {
  return number(ParamDesc::Type::Float, value, min, max);
}

lab::Control choice(int count) {
  lab::Control control;
  control.declaration.name = "kind";
  control.declaration.type = ParamDesc::Type::Choice;
  for (int i = 0; i < count; ++i) control.declaration.choices.push_back(std::string(1, char('a' + i)));
  control.value = control.declaration.choices.empty() ? "" : control.declaration.choices.back();
  return control;
}

std::string textOf(const SweepAxis& axis) {
  std::string text;
  for (const Value& value : axis.values) text += lab::plainText(value) + " ";
  if (!text.empty()) text.pop_back();
  return text;
}

std::string messageOf(const std::function<void()>& step) {
  try {
    step();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(SweepAxis, SuggestsTheDeclaredRange) {
  EXPECT_EQ(textOf(axisOf(whole(16, 4, 64))), "4 8 16 32 64") << "far apart: by factors of two";
  EXPECT_EQ(textOf(axisOf(whole(2, 1, 5))), "1 2 3 4 5") << "few whole numbers: each one";
  EXPECT_EQ(textOf(axisOf(real(0.5, 0, 1))), "0 0.2 0.4 0.6 0.8 1");
  EXPECT_TRUE(axisOf(whole(16, 4, 64)).logarithmic);
  EXPECT_FALSE(axisOf(real(0.5, 0, 1)).logarithmic);
}

TEST(SweepAxis, SuggestsValuesNearTheCurrentOneInAWideRange) {
  EXPECT_EQ(textOf(axisOf(real(0.5, 0, 1000))), "0.125 0.25 0.5 1 2") << "near the value, not across the wide range";
  EXPECT_EQ(textOf(axisOf(real(24, 1e-3, 1e6))), "6 12 24 48 96");
  EXPECT_EQ(textOf(axisOf(real(-2, {}, {}))), "-8 -6 -4 -2 0 2");
  EXPECT_EQ(textOf(axisOf(real(0, {}, {}))), "0 0.2 0.4 0.6 0.8 1");
  EXPECT_EQ(textOf(axisOf(whole(0, 0, 4294967295.0))), "0 1 2 3 4 5 6 7") << "a seed";
}

TEST(SweepAxis, HasAllValuesOfSwitchesAndChoices) {
  lab::Control toggle = choice(0);
  toggle.declaration.type = ParamDesc::Type::Bool;
  toggle.value = true;
  EXPECT_EQ(textOf(axisOf(toggle)), "false true");
  EXPECT_EQ(textOf(axisOf(choice(3))), "a b c");
  EXPECT_EQ(textOf(axisOf(choice(12), kMostOfTwo)), "a b c d e f g l") << "the first values and the current one";
}

TEST(SweepAxis, ControlWithoutValuesCannotBeSwept) {
  EXPECT_FALSE(canBeSwept(choice(0))) << "any text";
  EXPECT_FALSE(canBeSwept(choice(1)));
  EXPECT_TRUE(canBeSwept(choice(2)));
  EXPECT_NE(messageOf([] { axisOf(choice(1)); }).find("no values"), std::string::npos);
}

TEST(SweepAxis, CoversARange) {
  ParamDesc samples = whole(8, 1, 64).declaration, share = real(0, 0, 1).declaration;
  EXPECT_EQ(textOf(axisOf(samples, SweepRange{2, 18, 3, true})), "2 6 18");
  EXPECT_EQ(textOf(axisOf(samples, SweepRange{1, 3, 9, false})), "1 2 3") << "equal values after rounding occur once";
  EXPECT_EQ(textOf(axisOf(share, SweepRange{0.9, 0.3, 3, false})), "0.9 0.6 0.3") << "downwards";
  EXPECT_EQ(textOf(axisOf(share, SweepRange{0, 0.3, 4, false})), "0 0.1 0.2 0.3") << "without rounding digits";
}

TEST(SweepAxis, RefusesInvalidRanges) {
  ParamDesc declaration = real(0.5, 0, 1).declaration;
  auto refusal = [&](const SweepRange& range) { return messageOf([&] { axisOf(declaration, range); }); };
  EXPECT_EQ(refusal({0, 2, 3, false}), "sweep of x: 2 is out of range");
  EXPECT_EQ(refusal({0, 1, 3, true}), "sweep of x: the ends of a logarithmic range must be above 0");
  EXPECT_EQ(refusal({0, 1, 17, false}), "sweep of x: the number of steps is 17, not 2 to 16");
  EXPECT_EQ(refusal({1, 1, 3, false}), "sweep of x: the ends must be two different numbers");
  EXPECT_EQ(refusal({0, NAN, 3, false}), "sweep of x: the ends must be two different numbers");
  EXPECT_EQ(textOf(axisOf(declaration, std::vector<std::string>{"0.5", "1", "0.5"})), "0.5 1");
  EXPECT_NE(messageOf([&] { axisOf(declaration, std::vector<std::string>{"3"}); }), "");
}

}  // namespace sweep_axis_test
}  // namespace strobe::live
