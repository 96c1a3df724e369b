// SPDX-License-Identifier: MIT
#include "page/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "page/number.h"

namespace strobe::page {

namespace {

constexpr double kLegend = 150, kRow = 34, kBelow = 68, kGap = 1.5, kScaleWidth = 18;

struct Place {
  size_t row = 0, column = 0;
};

std::vector<double> allOf(const HeatMap& map) {
  std::vector<double> values;
  for (const auto& row : map.values)
    for (double value : row)
      if (std::isfinite(value)) values.push_back(value);
  return values;
}

void requireSound(const HeatMap& map) {
  STROBE_ASSERT(map.values.size() == map.y.size(), "{} rows, {} names", map.values.size(), map.y.size());
  for (const auto& row : map.values)
    STROBE_ASSERT(row.size() == map.x.size(), "{} columns, {} names", row.size(), map.x.size());
}

std::string textOf(const HeatMap& map, const Place& place) {
  if (!map.texts.empty()) return map.texts[place.row][place.column];
  double value = map.values[place.row][place.column];
  return std::isnan(value) ? kNotMeasured : fmt::format("{:.3g}", value);
}

class HeatDrawing {
 public:
  HeatDrawing(const HeatMap& map, int width, int height)
      : map_(map),
        x_(slotAxis(map.x_title, map.x)),
        y_(slotAxis(map.y_title, {map.y.rbegin(), map.y.rend()})),
        values_(map.scale, allOf(map)),
        frame_(x_.scaleOf({}), y_.scaleOf({}), width, height, leftOf(y_, y_.scaleOf({})), kLegend),
        svg_(width, height, map.about) {}

  std::string text() {
    frame_.draw(svg_, x_, y_);
    for (size_t row = 0; row < map_.y.size(); ++row)
      for (size_t column = 0; column < map_.x.size(); ++column) cell({row, column});
    if (map_.mark_smallest) frameAroundSmallest();
    legend();
    return svg_.finished();
  }

 private:
  double wide() const { return frame_.x().slot() * (frame_.right() - frame_.left()); }
  double tall() const { return frame_.y().slot() * (frame_.bottom() - frame_.top()); }
  double middleX(const Place& place) const { return frame_.px(double(place.column)); }
  double middleY(const Place& place) const { return frame_.py(double(map_.y.size() - 1 - place.row)); }

  void rectangle(const std::string& classes, const Place& place, double gap, const std::string& tip) {
    svg_.rectangle(classes, middleX(place) - wide() / 2 + gap, middleY(place) - tall() / 2 + gap, wide() - 2 * gap,
                   tall() - 2 * gap, tip);
  }

  void cell(const Place& place) {
    double value = map_.values[place.row][place.column];
    std::string step = std::isfinite(value) ? fmt::format("step{}", stepOf(values_, value)) : "nothing";
    std::string shown = textOf(map_, place);
    std::string tip = map_.tips.empty() ? fmt::format("{}, {}: {}", map_.x[place.column], map_.y[place.row], shown)
                                        : map_.tips[place.row][place.column];
    svg_.open(step);
    rectangle("cell", place, kGap / 2, tip);
    if (estimatedWidth(shown) < wide())
      svg_.text("inside", middleX(place), middleY(place) + 4, shown, Svg::Anchor::middle);
    svg_.close();
  }

  void frameAroundSmallest() {
    Place best;
    double least = INFINITY;
    for (size_t row = 0; row < map_.values.size(); ++row)
      for (size_t column = 0; column < map_.values[row].size(); ++column)
        if (map_.values[row][column] < least) least = map_.values[row][column], best = {row, column};
    if (std::isfinite(least)) rectangle("smallest", best, 1, "");
  }

  // Legend: shades with the largest at the top, and ticks of the values beside them.
  void legend() {
    double x = frame_.right() + 40, top = frame_.top() + 26, height = frame_.bottom() - top;
    svg_.text("title", frame_.right() + 24, frame_.top() + 10, map_.value_title);
    for (int step = 0; step < kSteps; ++step) {
      svg_.open(fmt::format("step{}", step));
      svg_.rectangle("cell", x, top + height * (kSteps - 1 - step) / kSteps, kScaleWidth, height / kSteps);
      svg_.close();
    }
    double last = INFINITY;
    for (const Tick& tick : values_.ticks()) {
      double y = top + height * (1 - tick.at);
      if (tick.label.empty() || last - y < 16) continue;
      svg_.path("tickmark", fmt::format("M{:.1f} {:.1f}h5", x + kScaleWidth, y));
      svg_.text("tick", x + kScaleWidth + 9, y + 4, tick.label);
      last = y;
    }
  }

  const HeatMap& map_;
  Axis x_, y_;
  Scale values_;
  Frame frame_;
  Svg svg_;
};

}  // namespace

int stepOf(const Scale& scale, double value) {
  return std::clamp(int(std::floor(scale.at(value) * kSteps)), 0, kSteps - 1);
}

std::string svgOf(const HeatMap& map, int width) {
  requireSound(map);
  int height = int(std::max(4.0, double(map.y.size())) * kRow + kBelow);
  return HeatDrawing(map, width, height).text();
}

}  // namespace strobe::page
