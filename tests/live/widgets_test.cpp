// SPDX-License-Identifier: MIT
// Widgets made from declarations: types, ranges, scales, tooltips and search.
#include "live/widgets.h"

#include <gtest/gtest.h>

namespace strobe::live {
namespace widgets_test {

using plan::ParamDesc;
using Kind = Widget::Kind;

ParamDesc number(ParamDesc::Type type, std::optional<double> min, std::optional<double> max, const char* unit = "") {
  ParamDesc declaration;
  declaration.name = "x";
  declaration.type = type;
  declaration.min = min;
  declaration.max = max;
  declaration.unit = unit;
  declaration.doc = "a number";
  return declaration;
}

ParamDesc choice(std::vector<std::string> choices) {
  ParamDesc declaration;
  declaration.type = ParamDesc::Type::Choice;
  declaration.choices = std::move(choices);
  return declaration;
}

TEST(Widgets, EveryTypeHasAWidget) {
  ParamDesc toggle;
  toggle.type = ParamDesc::Type::Bool;
  EXPECT_EQ(widgetOf(toggle).kind, Kind::Checkbox);
  EXPECT_EQ(widgetOf(choice({"a", "b"})).kind, Kind::Combo);
  EXPECT_EQ(widgetOf(choice({})).kind, Kind::Text);
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Int, 1, 64)).kind, Kind::IntSlider);
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Float, 0, 1)).kind, Kind::FloatSlider);
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Int, 1, {})).kind, Kind::IntDrag);
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Float, {}, {})).kind, Kind::FloatDrag);
}

TEST(Widgets, WideRangesAreLogarithmic) {
  auto logarithmic = [](double min, double max) {
    return widgetOf(number(ParamDesc::Type::Float, min, max)).logarithmic;
  };
  EXPECT_FALSE(logarithmic(0.001, 1));
  EXPECT_TRUE(logarithmic(0.001, 1.1));
  EXPECT_FALSE(logarithmic(0, 1000));
  EXPECT_TRUE(logarithmic(0, 1001));
  EXPECT_FALSE(logarithmic(-5000, 5000)) << "no logarithm of negative values";
}

TEST(Widgets, UnboundedRangeHasNoSlider) {
  Widget widget = widgetOf(number(ParamDesc::Type::Int, 0, 4294967295.0));
  EXPECT_EQ(widget.kind, Kind::IntDrag);
  EXPECT_EQ(widget.high, 4294967295.0);
}

TEST(Widgets, FormatsIncludeTheUnit) {
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Float, 0, 1, "px")).format, "%.4g px");
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Int, 0, 1)).format, "%d");
  EXPECT_EQ(widgetOf(number(ParamDesc::Type::Float, 0, 1, "%")).format, "%.4g %%");
}

TEST(Widgets, TextReadsBackAsTheValue) {
  EXPECT_EQ(lab::plainText(true), "true");
  EXPECT_EQ(lab::plainText(int64_t(-3)), "-3");
  EXPECT_EQ(lab::plainText(std::string("closest")), "closest");
  for (double value : {0.1, 1.0 / 3, 1e-30, 12345678.9}) EXPECT_EQ(std::stod(lab::plainText(value)), value);
}

lab::Control sample() {
  lab::Control control;
  control.declaration = choice({"near", "far"});
  control.declaration.name = "edges.reach";
  control.declaration.doc = "How far it looks";
  control.declaration.values = {{"near", "one pixel"}, {"far", "a tile"}};
  control.value = std::string("far");
  control.group = "edges";
  control.origin = "preset best";
  control.place = "passes/x.lua:12";
  return control;
}

TEST(Widgets, TooltipHasTheWholeDeclaration) {
  std::string text = tooltipOf(sample());
  for (const char* part :
       {"edges.reach", "How far it looks", "near: one pixel", "far: a tile", "preset best: far", "passes/x.lua:12"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  lab::Control ranged = sample();
  ranged.declaration = number(ParamDesc::Type::Float, 0.5, 2, "m");
  ranged.value = 1.5;
  EXPECT_NE(tooltipOf(ranged).find("0.5 to 2 m"), std::string::npos);
}

TEST(Widgets, SearchFindsWordsAnywhere) {
  EXPECT_TRUE(isFound(sample(), ""));
  EXPECT_TRUE(isFound(sample(), "REACH edges"));
  EXPECT_TRUE(isFound(sample(), "far it"));
  EXPECT_FALSE(isFound(sample(), "reach nothing"));
}

TEST(Widgets, NamesOmitTheirGroup) {
  EXPECT_EQ(shortName(sample()), "reach");
  lab::Control control = sample();
  control.group = "pipeline";
  EXPECT_EQ(shortName(control), "edges.reach");
}

// A number below the minimum means unset, and is shown as "auto".
TEST(Widgets, UnsetNumberIsShownAsAuto) {
  lab::Control control = sample();
  control.declaration = number(ParamDesc::Type::Float, 0, 10, "s");
  control.value = -1.0;
  EXPECT_TRUE(isOpen(control.declaration, -1));
  EXPECT_FALSE(isOpen(control.declaration, 0));
  EXPECT_NE(tooltipOf(control).find("preset best: auto"), std::string::npos) << tooltipOf(control);
}

TEST(Widgets, IdleControlHasAReason) {
  lab::Control control = sample();
  control.idle = "no pass reads it";
  EXPECT_NE(tooltipOf(control).find("has no effect: no pass reads it"), std::string::npos);
}

TEST(Widgets, BarShowsTheValuesPosition) {
  Widget even = widgetOf(number(ParamDesc::Type::Float, -2, 6)),
         by_factors = widgetOf(number(ParamDesc::Type::Int, 1, 10000));
  EXPECT_DOUBLE_EQ(shareOf(even, 0), 0.25);
  EXPECT_EQ(shareOf(even, 99), 1);
  ASSERT_TRUE(by_factors.logarithmic);
  EXPECT_EQ(shareOf(by_factors, 1), 0);
  EXPECT_DOUBLE_EQ(shareOf(by_factors, 100), 0.5);
  EXPECT_EQ(shareOf(by_factors, 10000), 1);
  EXPECT_EQ(shareOf(widgetOf(number(ParamDesc::Type::Float, 0, 5000)), 0), 0);
}

TEST(Widgets, SamplesCountUpToTheirTotal) {
  EXPECT_EQ(samplesText(312, 4096), "312 of 4096 samples");
  EXPECT_EQ(samplesText(4096, 4096), "4096 samples");
}

}  // namespace widgets_test
}  // namespace strobe::live
