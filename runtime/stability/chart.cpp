// SPDX-License-Identifier: MIT
#include "stability/chart.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "lab/html.h"

namespace strobe::stability::curves {

// ---- scales

namespace {

constexpr double kZeroShare = 0.07;  // of a logarithmic axis that has a 0: the place of it and the gap

std::string superscript(int number) {
  static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

// To 1, 3 or 10 times a power of ten.
double roundedDown(double power) {
  double whole = std::floor(power + 1e-9);
  return power - whole >= std::log10(3.0) - 1e-9 ? whole + std::log10(3.0) : whole;
}

double roundedUp(double power) {
  double whole = std::ceil(power - 1e-9);
  return whole - power >= 1 - std::log10(3.0) - 1e-9 ? whole - 1 + std::log10(3.0) : whole;
}

}  // namespace

std::string shownNumber(double value) {
  if (value == 0) return "0";
  double power = std::log10(std::abs(value));
  if (power > -3.5 && power < 4.5) return fmt::format("{:g}", value);
  int whole = int(std::floor(power + 1e-9));
  double front = value / std::pow(10.0, whole);
  return (std::abs(front - 1) < 1e-9 ? "" : fmt::format("{:g}·", front)) + "10" + superscript(whole);
}

Scale::Scale(Kind kind, const std::vector<double>& values, bool rounded) : kind_(kind), values_(values) {
  if (kind == Kind::even) return;
  std::vector<double> used;
  for (double value : values) {
    if (!std::isfinite(value)) continue;
    if (kind == Kind::log && value <= 0) zero_ = true;
    else used.push_back(kind == Kind::log ? std::log10(value) : value);
  }
  if (used.empty()) return;
  low_ = *std::min_element(used.begin(), used.end());
  high_ = *std::max_element(used.begin(), used.end());
  if (rounded && kind == Kind::log) low_ = roundedDown(low_), high_ = roundedUp(high_);
  if (high_ - low_ < 1e-9) high_ = low_ + 1;
}

double Scale::gap() const { return zero_ ? kZeroShare : 0; }

double Scale::at(double value) const {
  if (kind_ == Kind::even) {
    size_t i = size_t(std::lower_bound(values_.begin(), values_.end(), value) - values_.begin());
    return values_.size() < 2 ? 0 : double(std::min(i, values_.size() - 1)) / double(values_.size() - 1);
  }
  if (kind_ == Kind::linear) return std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
  if (value <= 0) return 0;
  return gap() + (1 - gap()) * std::clamp((std::log10(value) - low_) / (high_ - low_), 0.0, 1.0);
}

// Powers of ten; 2 and 5 times them where there are few; small ticks in between.
std::vector<Tick> Scale::logTicks() const {
  std::vector<Tick> ticks;
  if (zero_) ticks.push_back({0, "0"});
  double span = high_ - low_;
  for (int power = int(std::floor(low_)); power <= int(std::ceil(high_)); ++power)
    for (int digit = 1; digit <= 9; ++digit) {
      double exponent = power + std::log10(double(digit));
      if (exponent < low_ - 1e-9 || exponent > high_ + 1e-9) continue;
      bool large = digit == 1 || (span < 2.2 && (digit == 2 || digit == 5));
      if (!large && span > 8) continue;
      double value = std::strtod(fmt::format("{}e{}", digit, power).c_str(), nullptr);
      ticks.push_back({at(value), large ? shownNumber(value) : ""});
    }
  return ticks;
}

std::vector<Tick> Scale::linearTicks() const {
  double raw = (high_ - low_) / 8, power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = power * 10;
  for (double factor : {1.0, 1.5, 2.0, 3.0, 5.0})
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  std::vector<Tick> ticks;
  for (double value = std::ceil(low_ / step) * step; value <= high_ + 1e-9 * step; value += step)
    ticks.push_back({at(value), shownNumber(std::abs(value) < 1e-9 * step ? 0 : value)});
  return ticks;
}

std::vector<Tick> Scale::ticks() const {
  if (kind_ == Kind::log) return logTicks();
  if (kind_ == Kind::linear) return linearTicks();
  std::vector<Tick> ticks;
  for (double value : values_) ticks.push_back({at(value), shownNumber(value)});
  return ticks;
}

// ---- drawing

namespace {

constexpr int kLeft = 76, kRight = 200, kTop = 14, kBottom = 54, kInset = 12, kLabelStep = 17;

std::string classOf(int style) {
  return style == kFloorStyle ? "floor" : style == kErrorStyle ? "sigma" : fmt::format("m{}", style % kStyles);
}

// A mark about (x, y) by style.
std::string mark(int style, double x, double y, bool hollow, const std::string& tip) {
  auto polygon = [&](int corners, double radius, double turn) {
    std::string points;
    for (int i = 0; i < corners; ++i) {
      double angle = (turn + 360.0 * i / corners) * M_PI / 180;
      points += fmt::format("{:.1f},{:.1f} ", x + radius * std::sin(angle), y - radius * std::cos(angle));
    }
    points.pop_back();
    return fmt::format("polygon points=\"{}\"", points);
  };
  static const double kShapes[kStyles][3] = {{0, 3.6, 0},   {4, 5, 45}, {3, 5.4, 0}, {4, 5.2, 0},
                                             {3, 5.4, 180}, {5, 5, 0},  {6, 5, 0},   {3, 5.4, 90}};
  const auto& shape = kShapes[style % kStyles];
  std::string element = shape[0] == 0 ? fmt::format("circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"", x, y, shape[1] + 0.6)
                                      : polygon(int(shape[0]), shape[1], shape[2]);
  std::string name = element.substr(0, element.find(' '));
  std::string hint = tip.empty() ? "" : "<title>" + lab::escaped(tip) + "</title>";
  return fmt::format("<{}{}>{}</{}>", element, hollow ? " class=\"hollow\"" : "", hint, name);
}

class Drawing {
 public:
  Drawing(const Chart& chart, int width, int height)
      : chart_(chart), width_(width), height_(height), x_(xScale(chart)), y_(yScale(chart)) {}
  std::string text();

 private:
  static Scale xScale(const Chart& chart);
  static Scale yScale(const Chart& chart);
  double px(double value) const { return kLeft + kInset + x_.at(value) * (width_ - kLeft - kRight - 2 * kInset); }
  double py(double value) const {
    return height_ - kBottom - kInset - y_.at(value) * (height_ - kTop - kBottom - 2 * kInset);
  }
  double right() const { return width_ - kRight; }
  double bottom() const { return height_ - kBottom; }
  void band();
  void grid();
  void line(const ChartLine& line);
  void labels();

  const Chart& chart_;
  int width_, height_;
  Scale x_, y_;
  std::string svg_;
};

Scale Drawing::xScale(const Chart& chart) {
  std::vector<double> values;
  for (const ChartLine& line : chart.lines)
    for (const ChartPoint& point : line.points) values.push_back(point.x);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return Scale(chart.x_scale, values);
}

Scale Drawing::yScale(const Chart& chart) {
  std::vector<double> values;
  for (const ChartLine& line : chart.lines)
    for (const ChartPoint& point : line.points)
      if (point.y > 0 && std::isfinite(point.y)) values.push_back(point.y);
  double most = values.empty() ? 1 : *std::max_element(values.begin(), values.end());
  for (double& value : values) value = std::max(value, 1e-4 * most);
  return Scale(Scale::Kind::log, values, true);
}

void Drawing::grid() {
  svg_ += fmt::format("<rect class=\"plot\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", kLeft, kTop,
                      right() - kLeft, bottom() - kTop);
  double inner = width_ - kLeft - kRight - 2 * kInset, tall = height_ - kTop - kBottom - 2 * kInset;
  for (const Tick& tick : x_.ticks()) {
    double x = kLeft + kInset + tick.at * inner;
    if (!tick.label.empty())
      svg_ += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\">{4}</text>",
          x, kTop, bottom(), bottom() + 18, tick.label);
    svg_ += fmt::format("<path class=\"tickmark\" d=\"M{:.1f} {}v{}\"/>", x, bottom(), tick.label.empty() ? 3 : 6);
  }
  for (const Tick& tick : y_.ticks()) {
    double y = height_ - kBottom - kInset - tick.at * tall;
    if (!tick.label.empty())
      svg_ += fmt::format(
          "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"tick\" x=\"{3}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\">{5} %</text>",
          kLeft, y, right(), kLeft - 9, y + 4, tick.label);
    svg_ += fmt::format("<path class=\"tickmark\" d=\"M{} {:.1f}h{}\"/>", kLeft, y, tick.label.empty() ? -3 : -6);
  }
  // Where a logarithmic axis is broken, because it has a 0.
  if (x_.hasZero())
    svg_ += fmt::format("<path class=\"break\" d=\"M{:.1f} {}l6 -10m4 0l-6 10\"/>",
                        kLeft + kInset + 0.55 * x_.gap() * inner, bottom() + 5);
  double benign = px(chart_.benign);
  svg_ += fmt::format("<path class=\"benign\" d=\"M{:.1f} {}V{}\"><title>what the other axes use</title></path>",
                      benign, kTop, bottom());
  svg_ += fmt::format("<text class=\"title\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                      (kLeft + right()) / 2, height_ - 10, lab::escaped(chart_.x_title));
  svg_ += fmt::format(
      "<text class=\"title\" transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
      (kTop + bottom()) / 2, lab::escaped(chart_.y_title));
}

void Drawing::band() {
  for (const ChartLine& line : chart_.lines) {
    if (chart_.band <= 0 || line.style != kFloorStyle || line.points.empty()) continue;
    std::string path;
    for (const ChartPoint& point : line.points)
      if (!std::isnan(point.y))
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px(point.x), py(chart_.band * point.y));
    if (path.empty()) continue;
    svg_ += fmt::format("<path class=\"band\" d=\"{}V{}H{:.1f}Z\"/>", path, bottom(), px(line.points.front().x));
  }
}

// Runs of points to be trusted or not, each with the step that leads to it.
void Drawing::line(const ChartLine& line) {
  svg_ += fmt::format("<g class=\"{}\">", classOf(line.style));
  const auto& points = line.points;
  std::string solid, faint;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    if (std::isnan(points[i].y) || std::isnan(points[i + 1].y)) continue;
    std::string& path = points[i].faint || points[i + 1].faint ? faint : solid;
    std::string from = fmt::format("{:.1f} {:.1f}", px(points[i].x), py(points[i].y));
    if (!path.ends_with(from)) path += "M" + from;
    path += fmt::format("L{:.1f} {:.1f}", px(points[i + 1].x), py(points[i + 1].y));
  }
  if (!solid.empty()) svg_ += fmt::format("<path d=\"{}\"/>", solid);
  if (!faint.empty()) svg_ += fmt::format("<path class=\"faint\" d=\"{}\"/>", faint);
  if (line.style >= 0)
    for (const ChartPoint& point : points)
      if (!std::isnan(point.y)) svg_ += mark(line.style, px(point.x), py(point.y), point.hollow, point.tip);
  svg_ += "</g>\n";
}

// At the right end of each line, moved apart.
void Drawing::labels() {
  struct Label {
    const ChartLine* line;
    double wanted, y;
  };
  std::vector<Label> labels;
  for (const ChartLine& line : chart_.lines)
    for (auto point = line.points.rbegin(); point != line.points.rend(); ++point)
      if (!std::isnan(point->y)) {
        labels.push_back({&line, py(point->y), 0});
        break;
      }
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.wanted < b.wanted; });
  double next = kTop + 8;
  for (Label& label : labels) label.y = std::max(next, label.wanted), next = label.y + kLabelStep;
  double most = bottom() - 2;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label)
    label->y = std::min(label->y, most), most = label->y - kLabelStep;
  for (const Label& label : labels) {
    double x = right() + 30;
    svg_ += fmt::format(
        "<g class=\"{}\"><path class=\"lead\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/><path d=\"M{:.1f} {:.1f}h26\"/>",
        classOf(label.line->style), right() - kInset + 8, label.wanted, x - 4, label.y, x, label.y);
    if (label.line->style >= 0) svg_ += mark(label.line->style, x + 13, label.y, false, "");
    svg_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n", x + 31, label.y + 4,
                        lab::escaped(label.line->label));
  }
}

std::string Drawing::text() {
  svg_ = fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", width_, height_,
                     lab::escaped(chart_.about));
  grid();
  band();
  svg_ += "\n";
  for (const ChartLine& one : chart_.lines) line(one);
  labels();
  return svg_ + "</svg>\n";
}

}  // namespace

std::string svgOf(const Chart& chart, int width, int height) { return Drawing(chart, width, height).text(); }

const char* const kChartStyle = R"css(
:root { --m0: #6b6f78; --m1: #b4540a; --m2: #0b6bb5; --m3: #857000; --m4: #a3348a; --m5: #00785a; --m6: #c8102e; --m7: #5b3fb0; }
@media (prefers-color-scheme: dark) { :root { --m0: #a7abb5; --m1: #f0a05a; --m2: #62baf5; --m3: #dcc64e; --m4: #e88fd6; --m5: #45d3a6;
  --m6: #ff7a85; --m7: #b7a2ff; } }
svg.chart { width: 100%; max-width: 60rem; height: auto; display: block; margin: .6rem 0; font: 12.5px system-ui, "DejaVu Sans", sans-serif; }
.chart .plot { fill: var(--panel); stroke: var(--rule); } .chart .grid { stroke: var(--rule); fill: none; }
.chart .tick { fill: var(--soft); } .chart .title { fill: var(--ink); } .chart .tickmark, .chart .break { stroke: var(--soft); fill: none; }
.chart .benign { stroke: var(--soft); stroke-dasharray: 1 4; stroke-width: 1.5; fill: none; }
.chart .band { fill: var(--best); fill-opacity: .7; } .chart g path { fill: none; stroke: currentColor; stroke-width: 1.9; } .chart g .faint { opacity: .38; } .chart g text { fill: currentColor; }
.chart g .lead { stroke-width: .8; opacity: .6; stroke-dasharray: none; }
.chart g circle, .chart g polygon { fill: currentColor; stroke: currentColor; stroke-width: 1.3; } .chart g .hollow { fill: var(--panel); }
.chart .m0 { color: var(--m0); } .chart .m0 path { stroke-dasharray: 2 3; } .chart .m1 { color: var(--m1); }
.chart .m2 { color: var(--m2); } .chart .m2 path { stroke-dasharray: 7 3; } .chart .m3 { color: var(--m3); } .chart .m3 path { stroke-dasharray: 10 3 2 3; }
.chart .m4 { color: var(--m4); } .chart .m4 path { stroke-dasharray: 4 3; } .chart .m5 { color: var(--m5); } .chart .m5 path { stroke-dasharray: 12 4; }
.chart .m6 { color: var(--m6); } .chart .m6 path { stroke-width: 2.8; } .chart .m6 .lead { stroke-width: .8; }
.chart .m7 { color: var(--m7); } .chart .m7 path { stroke-dasharray: 6 2 2 2 2 2; }
.chart .floor { color: var(--ink); } .chart .floor path { stroke-width: 1.2; } .chart .sigma { color: var(--soft); } .chart .sigma path { stroke-width: 1.4; stroke-dasharray: 1 3; }
)css";

}  // namespace strobe::stability::curves
