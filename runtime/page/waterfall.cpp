// SPDX-License-Identifier: MIT
#include "page/waterfall.h"

#include <fmt/format.h>

#include <algorithm>

namespace strobe::page {

namespace {

constexpr int kBar = 24, kAround = 68;  // pixels: height of a bar with its gap; space above and below the plot
constexpr double kBarShare = 0.68;      // height of a bar as a share of its row
constexpr double kBeside = 90;          // pixels right of the plot, for text that starts at its border
constexpr double kErrorBar = 4;         // half the height of an error bar's ends, pixels

// Vertical axis with the names of the bars. Reversed, because slots count from the bottom.
ChartAxis rowsOf(const Waterfall& waterfall) {
  std::vector<std::string> names;
  for (auto bar = waterfall.bars.rbegin(); bar != waterfall.bars.rend(); ++bar) names.push_back(bar->name);
  return slotAxis("", std::move(names));
}

double endOf(const Waterfall& waterfall) {
  double end = 0;
  for (const Waterfall::Bar& bar : waterfall.bars)
    end = std::max({end, bar.start + bar.length, bar.end_range.given() ? bar.end_range.high : 0});
  return end;
}

void drawBar(Svg& svg, const ChartFrame& frame, const Waterfall::Bar& bar, size_t slot) {
  double y = frame.py(double(slot)), height = kBarShare * kBar, end = frame.px(bar.start + bar.length);
  double left = frame.px(bar.start);
  svg.open(classOf(bar.hollow ? 0 : 2));
  svg.rectangle(bar.hollow ? "bar hollow" : "bar", left, y - height / 2, end - left, height, bar.tip);
  if (bar.end_range.given()) {
    double low = frame.px(bar.end_range.low), high = frame.px(bar.end_range.high);
    svg.path("error", fmt::format("M{:.1f} {:.1f}H{:.1f}M{:.1f} {:.1f}v{}M{:.1f} {:.1f}v{}", low, y, high, low,
                                  y - kErrorBar, 2 * kErrorBar, high, y - kErrorBar, 2 * kErrorBar));
    end = std::max(end, high);
  }
  svg.close();
  svg.text("tick", end + 7, y + 4, bar.text);
}

}  // namespace

void align(std::vector<Waterfall>& waterfalls) {
  double end = 0, left = 0;
  for (const Waterfall& one : waterfalls) {
    const ChartAxis rows = rowsOf(one);
    end = std::max(end, endOf(one)), left = std::max(left, leftOf(rows, rows.scaleOf({})));
  }
  for (Waterfall& one : waterfalls) one.x.ends = {0, end}, one.left = left;
}

std::string svgOf(const Waterfall& waterfall, int width) {
  const ChartAxis rows = rowsOf(waterfall);
  const Scale y = rows.scaleOf({});
  const int height = int(waterfall.bars.size()) * kBar + kAround;
  const double left = std::max(waterfall.left, leftOf(rows, y));
  ChartFrame frame(waterfall.x.scaleOf({0, endOf(waterfall)}), y, width, height, left, kBeside);
  Svg svg(width, height, waterfall.about);
  frame.draw(svg, waterfall.x, rows);
  for (size_t i = 0; i < waterfall.bars.size(); ++i)
    drawBar(svg, frame, waterfall.bars[i], waterfall.bars.size() - 1 - i);
  return svg.finished();
}

}  // namespace strobe::page
