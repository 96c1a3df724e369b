// SPDX-License-Identifier: MIT
#include "page/waterfall.h"

#include <fmt/format.h>

#include <algorithm>

namespace strobe::page {

namespace {

constexpr int kRow = 24, kAround = 68;  // pixels of a bar with its gap; above and below the plot
constexpr double kBarShare = 0.68;      // of its row
constexpr double kBeside = 90;          // right of the plot, for a text that begins at its border
constexpr double kWhisker = 4;          // half the height of an error bar's ends

// From the top: slots count from the bottom.
Axis rowsOf(const Waterfall& waterfall) {
  std::vector<std::string> names;
  for (auto bar = waterfall.bars.rbegin(); bar != waterfall.bars.rend(); ++bar) names.push_back(bar->name);
  return slotAxis("", std::move(names));
}

Scale extentOf(const Waterfall& waterfall) {
  std::vector<double> values = {0};
  for (const Waterfall::Bar& bar : waterfall.bars) {
    values.push_back(bar.start + bar.length);
    if (bar.end_range.given()) values.push_back(bar.end_range.high);
  }
  return waterfall.x.scaleOf(values);
}

void drawBar(Svg& svg, const Frame& frame, const Waterfall::Bar& bar, size_t slot) {
  double y = frame.py(double(slot)), height = kBarShare * kRow, end = frame.px(bar.start + bar.length);
  double left = frame.px(bar.start);
  svg.open(classOf(bar.hollow ? 0 : 2));
  svg.rectangle(bar.hollow ? "bar hollow" : "bar", left, y - height / 2, end - left, height, bar.tip);
  if (bar.end_range.given()) {
    double low = frame.px(bar.end_range.low), high = frame.px(bar.end_range.high);
    svg.path("error", fmt::format("M{:.1f} {:.1f}H{:.1f}M{:.1f} {:.1f}v{}M{:.1f} {:.1f}v{}", low, y, high, low,
                                  y - kWhisker, 2 * kWhisker, high, y - kWhisker, 2 * kWhisker));
    end = std::max(end, high);
  }
  svg.close();
  svg.text("tick", end + 7, y + 4, bar.text);
}

}  // namespace

std::string svgOf(const Waterfall& waterfall, int width) {
  const Axis rows = rowsOf(waterfall);
  const Scale y = rows.scaleOf({});
  const int height = int(waterfall.bars.size()) * kRow + kAround;
  Frame frame(extentOf(waterfall), y, width, height, leftOf(rows, y), kBeside);
  Svg svg(width, height, waterfall.about);
  frame.draw(svg, waterfall.x, rows);
  for (size_t i = 0; i < waterfall.bars.size(); ++i)
    drawBar(svg, frame, waterfall.bars[i], waterfall.bars.size() - 1 - i);
  return svg.finished();
}

}  // namespace strobe::page
