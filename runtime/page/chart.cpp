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
constexpr double kNear = 30;        // pixels; a line with its end nearer to the right border has its label there
constexpr double kWhisker = 4;      // half the width of an error bar's ends, pixels
constexpr double kBarsShare = 0.7;  // share of a slot for its bars

class Drawing {
 public:
  Drawing(const Chart& chart, int width, int height)
      : chart_(chart), frame_(frameOf(chart, width, height)), svg_(width, height, chart.about) {}

  std::string text();
  void line(const Series& series);
  void band(const Series& series);
  void scatter(const Series& series);
  void bars(const Series& series);

 private:
  struct Label {
    const Series* series;
    double wanted, y;
    bool leads;  // draws a connection from the line's end
  };
  struct Box {
    double left, top, right, bottom;
    bool overlaps(const Box& other) const {
      return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
  };

  double lowest(double value) const { return value == -INFINITY ? frame_.bottom() : frame_.py(value); }
  void guide(const Guide& guide);
  void errorBars(const Point& point, double x);
  void marks(const Series& series);
  void take(const Point& point);
  void names();
  void name(const Series& series, const Point& point);
  std::vector<Label> placedLabels() const;
  void labels();
  void swatch(const Series& series, double x, double y);

  const Chart& chart_;
  Frame frame_;
  Svg svg_;
  std::vector<Box> taken_;  // boxes of names and marks
};

// Draw function of each kind, in drawing order.
struct DrawnAs {
  Series::Kind kind;
  void (Drawing::*draw)(const Series&);
};
constexpr DrawnAs kDrawings[] = {{Series::Kind::band, &Drawing::band},
                                 {Series::Kind::bar, &Drawing::bars},
                                 {Series::Kind::line, &Drawing::line},
                                 {Series::Kind::scatter, &Drawing::scatter}};

std::string at(double x, double y) { return fmt::format("{:.1f} {:.1f}", x, y); }

void Drawing::guide(const Guide& guide) {
  std::string d = guide.horizontal ? fmt::format("M{} {:.1f}H{}", frame_.left(), frame_.py(guide.at), frame_.right())
                                   : fmt::format("M{:.1f} {}V{}", frame_.px(guide.at), frame_.top(), frame_.bottom());
  svg_.path("guide", d, guide.tip);
}

void Drawing::errorBars(const Point& point, double x) {
  double y = frame_.py(point.y);
  std::string d;
  if (point.y_range.given()) {
    double low = lowest(point.y_range.low), high = frame_.py(point.y_range.high);
    d += fmt::format("M{} V{:.1f}", at(x, low), high);
    for (double end : {low, high}) d += fmt::format("M{}h{}", at(x - kWhisker, end), 2 * kWhisker);
  }
  if (point.x_range.given()) {
    double low = frame_.px(point.x_range.low), high = frame_.px(point.x_range.high);
    d += fmt::format("M{} H{:.1f}", at(low, y), high);
    for (double end : {low, high}) d += fmt::format("M{}v{}", at(end, y - kWhisker), 2 * kWhisker);
  }
  svg_.path("error", d);
}

void Drawing::marks(const Series& series) {
  for (const Point& point : series.points) {
    if (std::isnan(point.y)) continue;
    errorBars(point, frame_.px(point.x));
    svg_.mark(series.style, frame_.px(point.x), frame_.py(point.y), point.hollow, point.tip);
  }
}

// Draws segments beside a faint point as a path of their own.
void Drawing::line(const Series& series) {
  std::string solid, faint;
  for (size_t i = 0; i + 1 < series.points.size(); ++i) {
    const Point &from = series.points[i], &to = series.points[i + 1];
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

void Drawing::band(const Series& series) {
  std::string there, back;
  for (const Point& point : series.points) {
    if (!point.y_range.given()) continue;
    double x = frame_.px(point.x);
    there += (there.empty() ? "M" : "L") + at(x, frame_.py(point.y_range.high));
    back = "L" + at(x, lowest(point.y_range.low)) + back;
  }
  if (!there.empty()) svg_.path("band", there + back + "Z");
}

// Writes a name beside its mark: at the right, above, below or at the left, in the first place without overlap; at the
// right if all overlap.
void Drawing::name(const Series& series, const Point& point) {
  if (point.name.empty()) return;
  double x = frame_.px(point.x), y = frame_.py(point.y), wide = estimatedWidth(point.name);
  struct Place {
    double dx, dy;
    Svg::Anchor anchor;
  };
  using Anchor = Svg::Anchor;
  const Place places[] = {{9, 4, Anchor::start},    {8, -8, Anchor::start},  {8, 17, Anchor::start},
                          {0, -10, Anchor::middle}, {0, 19, Anchor::middle}, {-9, 4, Anchor::end},
                          {-8, -8, Anchor::end},    {-8, 17, Anchor::end}};
  auto boxOf = [&](const Place& place) {
    double left = x + place.dx - (place.anchor == Svg::Anchor::end ? wide : 0) -
                  (place.anchor == Svg::Anchor::middle ? wide / 2 : 0);
    return Box{left, y + place.dy - 12, left + wide, y + place.dy + 3};
  };
  auto free = [&](const Place& place) {
    Box box = boxOf(place);
    bool inside = box.left > frame_.left() && box.right < frame_.right() && box.top > frame_.top();
    return inside && std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.overlaps(other); });
  };
  const Place* place = std::find_if(std::begin(places), std::end(places), free);
  if (place == std::end(places)) place = places;
  taken_.push_back(boxOf(*place));
  svg_.text("name " + classOf(series.style), x + place->dx, y + place->dy, point.name, place->anchor);
}

// Adds the boxes of a mark and its error bars to `taken_`.
void Drawing::take(const Point& point) {
  double x = frame_.px(point.x), y = frame_.py(point.y);
  taken_.push_back({x - 5, y - 5, x + 5, y + 5});
  if (point.x_range.given())
    taken_.push_back({frame_.px(point.x_range.low), y - 2, frame_.px(point.x_range.high), y + 2});
  if (point.y_range.given()) taken_.push_back({x - 2, frame_.py(point.y_range.high), x + 2, lowest(point.y_range.low)});
}

void Drawing::names() {
  for (bool marks_first : {true, false})
    for (const Series& series : chart_.series)
      for (const Point& point : series.points) {
        if (series.kind != Series::Kind::scatter || std::isnan(point.y)) continue;
        if (marks_first) take(point);
        else name(series, point);
      }
}

void Drawing::scatter(const Series& series) { marks(series); }

// Bars side by side in their slots, from 0 or from the lower border.
void Drawing::bars(const Series& series) {
  size_t index = 0, count = 0;
  for (const Series& other : chart_.series) {
    if (&other == &series) index = count;
    count += other.kind == Series::Kind::bar;
  }
  double wide = frame_.x().slot() * (frame_.right() - frame_.left()) * kBarsShare / double(count);
  double base = chart_.y.kind == Scale::Kind::log ? frame_.bottom() : frame_.py(0);
  for (const Point& point : series.points) {
    if (std::isnan(point.y)) continue;
    double middle = frame_.px(point.x) + (double(index) - double(count - 1) / 2) * wide, y = frame_.py(point.y);
    double top = std::min(y, base), tall = std::abs(y - base);
    svg_.rectangle(point.hollow ? "bar hollow" : "bar", middle - wide * 0.46, top, wide * 0.92, tall, point.tip);
    svg_.hatch(series.style, middle - wide * 0.46, top, wide * 0.92, tall);
    errorBars(point, middle);
  }
}

// Labels from top to bottom, moved apart. A line that reaches the right border has its label at the height of its last
// value; other labels start at the top.
std::vector<Drawing::Label> Drawing::placedLabels() const {
  std::vector<Label> labels;
  for (const Series& series : chart_.series) {
    if (series.label.empty()) continue;
    double wanted = frame_.top();
    auto last = std::find_if(series.points.rbegin(), series.points.rend(), [](const Point& p) { return p.y == p.y; });
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

void Drawing::swatch(const Series& series, double x, double y) {
  if (series.kind == Series::Kind::band) return svg_.rectangle("band", x, y - 6, kSwatch, 12);
  if (series.kind == Series::Kind::bar) {
    svg_.rectangle("bar", x, y - 6, kSwatch, 12);
    return svg_.hatch(series.style, x, y - 6, kSwatch, 12);
  }
  if (series.kind == Series::Kind::line) svg_.path("", "M" + at(x, y) + fmt::format("h{}", kSwatch));
  svg_.mark(series.style, x + kSwatch / 2, y);
}

void Drawing::labels() {
  for (const Label& label : placedLabels()) {
    double x = frame_.right() + kSwatchAt;
    svg_.open(classOf(label.series->style));
    if (label.leads) svg_.path("lead", "M" + at(frame_.right() - 4, label.wanted) + "L" + at(x - 4, label.y));
    swatch(*label.series, x, label.y);
    svg_.text("label", x + kTextAt, label.y + 4, label.series->label);
    svg_.close();
  }
}

std::string Drawing::text() {
  frame_.draw(svg_, chart_.x, chart_.y);
  for (const Guide& one : chart_.guides) guide(one);
  for (const DrawnAs& drawn : kDrawings)
    for (const Series& series : chart_.series) {
      if (series.kind != drawn.kind) continue;
      svg_.open(classOf(series.style));
      (this->*drawn.draw)(series);
      svg_.close();
    }
  names();
  labels();
  return svg_.finished();
}

void addEnds(const Interval& interval, std::vector<double>& values) {
  if (interval.given()) values.insert(values.end(), {interval.low, interval.high});
}

std::vector<double> xValues(const Chart& chart) {
  std::vector<double> values;
  for (const Series& series : chart.series)
    for (const Point& point : series.points) {
      values.push_back(point.x);
      addEnds(point.x_range, values);
    }
  for (const Guide& guide : chart.guides)
    if (!guide.horizontal) values.push_back(guide.at);
  return values;
}

// Values that the y axis covers. Bands count only without other values, because a band may extend over the border.
std::vector<double> yValues(const Chart& chart) {
  std::vector<double> values, of_bands;
  for (const Series& series : chart.series)
    for (const Point& point : series.points) {
      bool band = series.kind == Series::Kind::band;
      if (!band) values.push_back(point.y);
      if (series.kind == Series::Kind::bar && chart.y.kind == Scale::Kind::linear) values.push_back(0);
      addEnds(point.y_range, band ? of_bands : values);
    }
  for (const Guide& guide : chart.guides)
    if (guide.horizontal) values.push_back(guide.at);
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

Frame frameOf(const Chart& chart, int width, int height) {
  Scale y = chart.y.scaleOf(yValues(chart));
  double left = leftOf(chart.y, y);
  return Frame(chart.x.scaleOf(xValues(chart)), std::move(y), width, height, left, labelsWidth(chart));
}

std::string svgOf(const Chart& chart, int width, int height) { return Drawing(chart, width, height).text(); }

}  // namespace strobe::page
