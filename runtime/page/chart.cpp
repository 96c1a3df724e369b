// SPDX-License-Identifier: MIT
#include "page/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strobe::page {

namespace {

// Pixels: from the plot to a label's swatch, width of the swatch, from the swatch's start to the text, distance of
// labels.
constexpr double kSwatchAt = 30, kSwatch = 26, kTextAt = 31, kLabelStep = 17;
constexpr double kNear = 30;    // pixels; a line with its end nearer to the right border has its label there
constexpr double kWhisker = 4;  // half the width of an error bar's ends, pixels

class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, int width, int height)
      : chart_(chart), frame_(frameOf(chart, width, height)), svg_(width, height, chart.about) {}

  std::string text();
  void line(const Series& series);
  void band(const Series& series);
  void marks(const Series& series);

 private:
  struct Label {
    const Series* series;
    double wanted, y;
    bool leads;  // draws a connection from the line's end
  };

  double lowest(double value) const { return value == -INFINITY ? frame_.bottom() : frame_.py(value); }
  void guide(const Guide& guide);
  void errorBar(const ChartPoint& point);
  std::vector<Label> placedLabels() const;
  void labels();
  void swatch(const Series& series, double x, double y);

  const Chart& chart_;
  ChartFrame frame_;
  Svg svg_;
};

// Draw function of each kind, in drawing order.
struct DrawnAs {
  Series::Kind kind;
  void (ChartDrawing::*draw)(const Series&);
};
constexpr DrawnAs kDrawings[] = {{Series::Kind::band, &ChartDrawing::band},
                                 {Series::Kind::line, &ChartDrawing::line},
                                 {Series::Kind::scatter, &ChartDrawing::marks}};

std::string at(double x, double y) { return fmt::format("{:.1f} {:.1f}", x, y); }

void ChartDrawing::guide(const Guide& guide) {
  svg_.path("guide", fmt::format("M{:.1f} {}V{}", frame_.px(guide.at), frame_.top(), frame_.bottom()), guide.tip);
}

void ChartDrawing::errorBar(const ChartPoint& point) {
  if (!point.y_range.given()) return;
  double x = frame_.px(point.x), low = lowest(point.y_range.low), high = frame_.py(point.y_range.high);
  std::string d = fmt::format("M{} V{:.1f}", at(x, low), high);
  for (double end : {low, high}) d += fmt::format("M{}h{}", at(x - kWhisker, end), 2 * kWhisker);
  svg_.path("error", d);
}

void ChartDrawing::marks(const Series& series) {
  for (const ChartPoint& point : series.points) {
    if (std::isnan(point.y)) continue;
    errorBar(point);
    svg_.mark(series.style, frame_.px(point.x), frame_.py(point.y), point.hollow, point.tip);
  }
}

// Draws segments beside a faint point as a path of their own.
void ChartDrawing::line(const Series& series) {
  std::string solid, faint;
  for (size_t i = 0; i + 1 < series.points.size(); ++i) {
    const ChartPoint &from = series.points[i], &to = series.points[i + 1];
    if (std::isnan(from.y) || std::isnan(to.y)) continue;
    std::string& d = from.faint || to.faint ? faint : solid;
    std::string start = at(frame_.px(from.x), frame_.py(from.y)), end = at(frame_.px(to.x), frame_.py(to.y));
    if (!d.ends_with(start)) d += "M" + start;
    if (series.stepped) d += "L" + at(frame_.px(to.x), frame_.py(from.y));
    d += "L" + end;
  }
  svg_.path("", solid);
  svg_.path("faint", faint);
  marks(series);
}

void ChartDrawing::band(const Series& series) {
  std::string there, back;
  for (const ChartPoint& point : series.points) {
    if (!point.y_range.given()) continue;
    double x = frame_.px(point.x);
    there += (there.empty() ? "M" : "L") + at(x, frame_.py(point.y_range.high));
    back = "L" + at(x, lowest(point.y_range.low)) + back;
  }
  if (!there.empty()) svg_.path("band", there + back + "Z");
}

// Labels from top to bottom, moved apart. A line that reaches the right border has its label at the height of its last
// value; other labels start at the top.
std::vector<ChartDrawing::Label> ChartDrawing::placedLabels() const {
  std::vector<Label> labels;
  for (const Series& series : chart_.series) {
    if (series.label.empty()) continue;
    double wanted = frame_.top();
    auto last =
        std::find_if(series.points.rbegin(), series.points.rend(), [](const ChartPoint& p) { return p.y == p.y; });
    bool reaches = series.kind == Series::Kind::line && last != series.points.rend() &&
                   frame_.px(last->x) > frame_.right() - kNear;
    if (reaches) wanted = frame_.py(last->y);
    labels.push_back({&series, wanted, 0, reaches});
  }
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.wanted < b.wanted; });
  double next = frame_.top() + 8;
  for (Label& label : labels) label.y = std::max(next, label.wanted), next = label.y + kLabelStep;
  double most = frame_.bottom() - 2;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label)
    label->y = std::min(label->y, most), most = label->y - kLabelStep;
  return labels;
}

void ChartDrawing::swatch(const Series& series, double x, double y) {
  if (series.kind == Series::Kind::band) return svg_.rectangle("band", x, y - 6, kSwatch, 12);
  if (series.kind == Series::Kind::line) svg_.path("", "M" + at(x, y) + fmt::format("h{}", kSwatch));
  svg_.mark(series.style, x + kSwatch / 2, y);
}

void ChartDrawing::labels() {
  for (const Label& label : placedLabels()) {
    double x = frame_.right() + kSwatchAt;
    svg_.open(classOf(label.series->style));
    if (label.leads) svg_.path("lead", "M" + at(frame_.right() - 4, label.wanted) + "L" + at(x - 4, label.y));
    swatch(*label.series, x, label.y);
    svg_.text("label", x + kTextAt, label.y + 4, label.series->label);
    svg_.close();
  }
}

std::string ChartDrawing::text() {
  frame_.draw(svg_, chart_.x, chart_.y);
  for (const Guide& one : chart_.guides) guide(one);
  for (const DrawnAs& drawn : kDrawings)
    for (const Series& series : chart_.series) {
      if (series.kind != drawn.kind) continue;
      svg_.open(classOf(series.style));
      (this->*drawn.draw)(series);
      svg_.close();
    }
  labels();
  return svg_.finished();
}

std::vector<double> xValues(const Chart& chart) {
  std::vector<double> values;
  for (const Series& series : chart.series)
    for (const ChartPoint& point : series.points) values.push_back(point.x);
  for (const Guide& guide : chart.guides) values.push_back(guide.at);
  return values;
}

// Values that the y axis covers. Bands count only without other values, because a band may extend over the border.
std::vector<double> yValues(const Chart& chart) {
  std::vector<double> values, of_bands;
  for (const Series& series : chart.series)
    for (const ChartPoint& point : series.points) {
      bool band = series.kind == Series::Kind::band;
      if (!band) values.push_back(point.y);
      if (point.y_range.given())
        for (double end : {point.y_range.low, point.y_range.high}) (band ? of_bands : values).push_back(end);
    }
  bool any = std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  return any ? values : of_bands;
}

// Width of the labels at the right, pixels.
double labelsWidth(const Chart& chart) {
  double widest = 0;
  for (const Series& series : chart.series) widest = std::max(widest, estimatedWidth(series.label));
  return widest == 0 ? 16 : kSwatchAt + kTextAt + widest + 6;
}

}  // namespace

ChartFrame frameOf(const Chart& chart, int width, int height) {
  Scale y = chart.y.scaleOf(yValues(chart));
  double left = leftOf(chart.y, y);
  return ChartFrame(chart.x.scaleOf(xValues(chart)), std::move(y), width, height, left, labelsWidth(chart));
}

std::string svgOf(const Chart& chart, int width, int height) { return ChartDrawing(chart, width, height).text(); }

}  // namespace strobe::page
