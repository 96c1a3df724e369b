// SPDX-License-Identifier: MIT
// Charts draw values at their place on the scales, and series differ without colour. Charts are read as elements with
// attributes.
#include "page/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "page/standalone.h"
#include "page/templates.h"

namespace strobe::page {
namespace chart_test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string group;  // class of the innermost <g>
  std::string text;   // up to the next element
  double number(const std::string& attribute) const { return std::stod(attributes.at(attribute)); }
  std::string kind() const { return attributes.count("class") ? attributes.at("class") : ""; }
};

std::vector<Element> elementsOf(const std::string& svg) {
  static const std::regex tag(R"rx(<(/?)([a-z]+)([^>]*?)/?>([^<]*))rx"), attribute(R"rx(([a-z-]+)="([^"]*)")rx");
  std::vector<Element> elements;
  std::vector<std::string> groups = {""};
  for (std::sregex_iterator at(svg.begin(), svg.end(), tag), end; at != end; ++at) {
    Element element{(*at)[2], {}, "", (*at)[4]};
    if ((*at)[1] == "/") {
      if (element.name == "g") groups.pop_back();
      continue;
    }
    std::string inside = (*at)[3];
    for (std::sregex_iterator a(inside.begin(), inside.end(), attribute); a != end; ++a)
      element.attributes[(*a)[1]] = (*a)[2];
    if (element.name == "g") groups.push_back(element.kind());
    element.group = groups.back();
    elements.push_back(element);
  }
  return elements;
}

std::vector<Element> those(const std::string& svg, const std::string& name, const std::string& kind = "") {
  std::vector<Element> found;
  for (const Element& element : elementsOf(svg))
    if (element.name == name && element.kind() == kind) found.push_back(element);
  return found;
}

// Points on a path with the absolute commands M, L, H and V.
std::vector<std::array<double, 2>> visited(const std::string& d) {
  static const std::regex command(R"rx(([MLHVmhv])\s*(-?[0-9.]+)[ ,]?(-?[0-9.]+)?)rx");
  std::vector<std::array<double, 2>> places;
  std::array<double, 2> pen = {0, 0};
  for (std::sregex_iterator at(d.begin(), d.end(), command), end; at != end; ++at) {
    char letter = (*at)[1].str()[0];
    if (std::islower(static_cast<unsigned char>(letter))) continue;
    double first = std::stod((*at)[2]);
    if (letter == 'H') pen[0] = first;
    else if (letter == 'V') pen[1] = first;
    else pen = {first, std::stod((*at)[3])};
    places.push_back(pen);
  }
  return places;
}

Chart withAxes() {
  Chart chart;
  chart.x = {"speed & <more>", Scale::Kind::log};
  chart.y = {"error", Scale::Kind::log};
  return chart;
}

TEST(Chart, PointLiesAtItsValues) {
  Chart chart = withAxes();
  chart.guides = {{10, "here"}};
  chart.series = {{"one", 0, {{1, 1, "low"}, {10, 10, "middle", true}, {100, 100, "high", false, true}}}};
  std::string svg = svgOf(chart);
  ChartFrame frame = frameOf(chart);
  // Both axes span two powers of ten.
  EXPECT_DOUBLE_EQ(frame.px(10), (frame.px(1) + frame.px(100)) / 2);
  EXPECT_DOUBLE_EQ(frame.py(10), (frame.py(1) + frame.py(100)) / 2);
  std::vector<Element> hollow = those(svg, "circle", "hollow");
  ASSERT_EQ(hollow.size(), 1u);
  EXPECT_NEAR(hollow[0].number("cx"), frame.px(10), 0.06);
  EXPECT_NEAR(hollow[0].number("cy"), frame.py(10), 0.06);
  auto faint = visited(those(svg, "path", "faint").at(0).attributes["d"]);
  ASSERT_EQ(faint.size(), 2u);
  EXPECT_NEAR(faint[0][0], frame.px(10), 0.06);
  EXPECT_NEAR(faint[1][1], frame.py(100), 0.06);
  EXPECT_NEAR(visited(those(svg, "path", "guide").at(0).attributes["d"]).at(0)[0], frame.px(10), 0.06);
  EXPECT_NE(svg.find("speed &amp; &lt;more&gt;"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Chart, SmallValuesLieOnTheLowestDecade) {
  Chart chart = withAxes();
  chart.y.decades = 2;
  chart.series = {{"", 0, {{1, 100}, {2, 1}, {3, 1e-9}, {4, 0}}}};
  ChartFrame frame = frameOf(chart);
  EXPECT_DOUBLE_EQ(frame.py(1e-9), frame.py(1));
  EXPECT_DOUBLE_EQ(frame.py(0), frame.py(1));
  EXPECT_FALSE(frame.y().hasZero());
}

TEST(Chart, GapInALineStays) {
  Chart chart = withAxes();
  chart.series = {{"", 0, {{1, 1}, {2, 2}, {3, kNone}, {4, 4}, {5, 5}}}};
  std::string svg = svgOf(chart);
  EXPECT_EQ(those(svg, "circle").size(), 4u);
  std::string d;
  for (const Element& path : those(svg, "path"))
    if (path.group == "s0") d = path.attributes.at("d");
  EXPECT_EQ(std::count(d.begin(), d.end(), 'M'), 2) << d;
}

// A front moves to the next x at the current y, then to the point: no corner is better than a point.
TEST(Chart, FrontIsAStair) {
  Chart chart;
  chart.series = {{"front", kFrontStyle, {{1, 5}, {2, 3}, {4, 1}}, Series::Kind::line, true}};
  std::string svg = svgOf(chart);
  ChartFrame frame = frameOf(chart);
  std::vector<std::array<double, 2>> expected = {{1, 5}, {2, 5}, {2, 3}, {4, 3}, {4, 1}}, places;
  for (const Element& path : those(svg, "path"))
    if (path.group == "front" && places.empty()) places = visited(path.attributes.at("d"));
  ASSERT_EQ(places.size(), expected.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(places[i][0], frame.px(expected[i][0]), 0.06);
    EXPECT_NEAR(places[i][1], frame.py(expected[i][1]), 0.06);
  }
}

TEST(Chart, ErrorBarsSpanTheirRange) {
  Chart chart;
  ChartPoint point{2, 3};
  point.y_range = {2, 6};
  chart.series = {{"one", 1, {point}, Series::Kind::scatter}};
  std::string svg = svgOf(chart);
  ChartFrame frame = frameOf(chart);
  EXPECT_DOUBLE_EQ(frame.y().at(2), 0) << "the axis includes the ends of error bars";
  EXPECT_DOUBLE_EQ(frame.y().at(6), 1);
  auto places = visited(those(svg, "path", "error").at(0).attributes["d"]);
  auto reached = [&](double x, double y) {
    return std::any_of(places.begin(), places.end(), [&](const auto& place) {
      return std::abs(place[0] - frame.px(x)) < 0.06 && std::abs(place[1] - frame.py(y)) < 0.06;
    });
  };
  EXPECT_TRUE(reached(2, 2));
  EXPECT_TRUE(reached(2, 6));
}

TEST(Chart, BandFillsTheRangesOfItsPoints) {
  Chart chart;
  Series band{"sure", 2, {{1, 0}, {3, 0}}, Series::Kind::band};
  band.points[0].y_range = {-INFINITY, 4};
  band.points[1].y_range = {2, 5};
  chart.series = {band, {"", 0, {{1, 1}, {3, 6}}}};
  std::string svg = svgOf(chart);
  ChartFrame frame = frameOf(chart);
  auto places = visited(those(svg, "path", "band").at(0).attributes["d"]);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_NEAR(places[0][1], frame.py(4), 0.06);
  EXPECT_NEAR(places[1][1], frame.py(5), 0.06);
  EXPECT_NEAR(places[2][1], frame.py(2), 0.06);
  EXPECT_NEAR(places[3][1], frame.bottom(), 0.06) << "-infinity is drawn at the border";
}

// Colours repeat with other marks.
TEST(Chart, ManySeriesDifferByColourAndMark) {
  std::set<std::string> looks;
  const int many = 4 * kStyles;
  for (int style = 0; style < many; ++style) {
    Svg svg(10, 10, "");
    svg.mark(style, 5, 5);
    looks.insert(classOf(style) + svg.finished());
  }
  EXPECT_EQ(looks.size(), size_t(many));
}

TEST(Chart, EveryClassHasAStyle) {
  Chart chart = withAxes();
  ChartPoint point{1, 0, "", true};
  point.y_range = {0.5, 2};
  chart.guides = {{3, ""}};
  for (Series::Kind kind : {Series::Kind::line, Series::Kind::band, Series::Kind::scatter})
    for (int style = kFrontStyle; style < kStyles; ++style)
      chart.series.push_back({"x", style, {point, {2, 2, "", false, true}, {3, 1}}, kind});
  std::string style(asset("chart.css"));
  std::set<std::string> missing;
  for (const Element& element : elementsOf(svgOf(chart))) {
    std::string classes = element.kind();
    size_t space = classes.find(' ');
    for (const std::string& one : {classes.substr(0, space), space < classes.size() ? classes.substr(space + 1) : ""})
      if (!one.empty() && style.find("." + one) == std::string::npos) missing.insert(one);
  }
  missing.erase("label");
  EXPECT_TRUE(missing.empty()) << *missing.begin();
}

// For programs without the page's style and without custom properties.
TEST(Standalone, HasItsStyleAndSize) {
  Chart chart;
  chart.series = {{"a", 1, {{1, 2}, {3, 4}}}};
  std::string svg = svgOf(chart, 400, 300), file = standaloneSvg(svg);
  EXPECT_TRUE(
      file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" width=\"400\" height=\"300\" "));
  EXPECT_NE(file.find(".chart .s1 { color: #b4540a; }"), std::string::npos);
  EXPECT_EQ(file.find("var("), std::string::npos);
  EXPECT_EQ(file.find("@media"), std::string::npos);
  EXPECT_TRUE(file.ends_with(svg.substr(svg.find('\n') + 1))) << "the drawing is unchanged";
}

}  // namespace chart_test
}  // namespace strobe::page
