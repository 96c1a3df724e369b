// SPDX-License-Identifier: MIT
// Bars of a waterfall begin at the end of the previous bar.
#include "page/waterfall.h"

#include <gtest/gtest.h>

#include <regex>

namespace strobe::page {
namespace waterfall_test {

struct Bar {
  double x, y, width;
};

std::vector<Bar> barsOf(const std::string& svg) {
  static const std::regex bar(R"rx(<rect class="bar[a-z ]*" x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)")rx");
  std::vector<Bar> bars;
  for (std::sregex_iterator at(svg.begin(), svg.end(), bar), end; at != end; ++at)
    bars.push_back({std::stod((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3])});
  return bars;
}

Waterfall three() {
  Waterfall waterfall;
  waterfall.about = "three & more";
  waterfall.x.title = "ms";
  waterfall.bars = {
      {"first", 0, 2, {}, "2 ms"}, {"second", 2, 4, {5, 7}, "4 ms"}, {"third", 6, 1, {}, "1 ms", "", true}};
  return waterfall;
}

TEST(Waterfall, BarsFollowEachOther) {
  std::string svg = svgOf(three());
  std::vector<Bar> bars = barsOf(svg);
  ASSERT_EQ(bars.size(), 3u);
  for (size_t i = 1; i < 3; ++i) {
    EXPECT_NEAR(bars[i].x, bars[i - 1].x + bars[i - 1].width, 0.11);
    EXPECT_GT(bars[i].y, bars[i - 1].y) << "from top to bottom";
  }
  EXPECT_NEAR(bars[1].width, 2 * bars[0].width, 0.11);
  for (const char* text :
       {"aria-label=\"three &amp; more\"", ">second<", ">4 ms<", "class=\"error\"", "class=\"bar hollow\""})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Waterfall, AlignedWaterfallsShareAnAxis) {
  Waterfall longer = three();
  longer.bars.push_back({"a name that needs a great deal of room", 7, 7, {}, "7 ms"});
  std::vector<Waterfall> both = {three(), longer};
  align(both);
  std::vector<Bar> first = barsOf(svgOf(both[0])), second = barsOf(svgOf(both[1]));
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first[i].x, second[i].x);
    EXPECT_EQ(first[i].width, second[i].width);
  }
  EXPECT_LT(first[0].width, barsOf(svgOf(three()))[0].width) << "the shared axis is longer than its own";
}

}  // namespace waterfall_test
}  // namespace strobe::page
