// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/shot_data.h"
#include "page/chart.h"
#include "page/svg.h"
#include "study/gallery.h"
#include "study/report.h"

namespace strobe::study {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// Points of `shots`, and their Pareto front.
class Front {
 public:
  Front(const Results& results, const std::vector<ShotSummary>& shots, const FrontLayout& layout)
      : results_(results), shots_(shots), layout_(layout), x_(measureNamed(layout.x)), y_(measureNamed(layout.y)) {
    for (const ShotSummary& shot : shots)
      for (const FrontPoint& one : frontPoints(results, shot, layout))
        if (std::isfinite(one.x)) all_.push_back(one);
    front_ = frontOf(all_, layout);
  }

  bool empty() const { return all_.empty(); }
  page::Chart chart() const;
  page::Table table() const;
  std::string text() const {
    return fmt::format("{} of {} points are on the front: no other point of the shot is as good in both measures.",
                       front_.size(), all_.size());
  }

 private:
  // Pareto front as steps; if all shots are together, the line y = x over the range of x.
  page::Series line() const;
  page::ChartAxis axis(const Measure& measure) const {
    page::ChartAxis axis;
    axis.title = headOf(measure, layout_.region);
    double least = kUnbounded, most = 0;
    for (const FrontPoint& one : all_) {
      if (layout_.together || &measure == &x_) least = std::min(least, one.x), most = std::max(most, one.x);
      if (layout_.together || &measure == &y_) least = std::min(least, one.y), most = std::max(most, one.y);
    }
    bool wide = least > 0 && most > 5 * least;
    // Both axes of y = x have one scale, so that the line is straight.
    const bool log = wide && (layout_.together || measure.better == Better::lower);
    axis.kind = log ? page::Scale::Kind::log : page::Scale::Kind::linear;
    axis.rounded = !wide;
    return axis;
  }

  const Results& results_;
  const std::vector<ShotSummary>& shots_;
  const FrontLayout& layout_;
  const Measure& x_;
  const Measure& y_;
  std::vector<FrontPoint> all_;
  std::vector<FrontPoint> front_;
};

page::Series Front::line() const {
  page::Series line;
  line.style = page::kFrontStyle;
  if (layout_.together) {
    auto [least, most] = std::minmax_element(all_.begin(), all_.end(),
                                             [](const FrontPoint& a, const FrontPoint& b) { return a.x < b.x; });
    line.label = "y = x";
    for (double x : {least->x, most->x}) line.points.push_back({x, x});
  } else {
    line.label = "front", line.stepped = true;
    for (const FrontPoint& one : front_) line.points.push_back({one.x, one.y});
  }
  return line;
}

page::Chart Front::chart() const {
  page::Chart chart;
  chart.x = axis(x_), chart.y = axis(y_);
  chart.about = layout_.together
                    ? fmt::format("{} against {} of every shot, method and value", chart.y.title, chart.x.title)
                    : fmt::format("{}: {} against {} of every method and value; the front is in the table below",
                                  shots_.front().title, chart.y.title, chart.x.title);
  chart.series.push_back(line());
  int style = 0;
  for (const ArmSummary& arm : results_.arms) {
    if (arm.role != ArmRole::method) continue;
    page::Series series;
    series.label = arm.name, series.style = style++, series.kind = page::Series::Kind::scatter;
    for (const FrontPoint& one : all_) {
      if (one.point->arm != arm.name) continue;
      page::ChartPoint point{one.x, one.y};
      point.tip = fmt::format("{}{}, {}: {}, {}", layout_.together ? one.group->shot + ", " : "", arm.name,
                              describe(*one.group), shownValue(x_, one.x), shownValue(y_, one.y));
      point.hollow = !one.point->limits.empty();
      series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(series);
  }
  return chart;
}

page::Table Front::table() const {
  page::Table table;
  table.columns = {"method", "values", {headOf(x_, layout_.region), true}, {headOf(y_, layout_.region), true}};
  for (const FrontPoint& one : front_)
    table.add({one.point->arm, describe(*one.group), page::TableCell(one.x, shownValue(x_, one.x)),
               page::TableCell(one.y, shownValue(y_, one.y))});
  return table;
}

}  // namespace

Parts frontParts(const Results& results) {
  const FrontLayout& layout = *results.layout.front;
  Parts parts = {heading(layout.title.empty() ? "Front" : layout.title, 2, "front", ReportPart::kRead),
                 text(layout.note, Tone::plain, ReportPart::kRead)};
  auto figure = [&](const Front& front, const std::string& name) {
    page::Chart chart = front.chart();
    parts.push_back(
        {page::Figure{page::svgOf(chart), "Hollow marks: a limit was met.", lab::fileNameOf(name), chart.about},
         ReportPart::kRead});
  };
  if (layout.together) {
    Front front(results, results.shots, layout);
    if (!front.empty()) figure(front, "front");
    return parts;
  }
  for (const ShotSummary& shot : results.shots) {
    std::vector<ShotSummary> alone = {shot};
    Front front(results, alone, layout);
    if (front.empty()) continue;
    parts.push_back(heading(shot.title, 3, "front-" + lab::fileNameOf(shot.name)));
    parts.push_back(text(front.text(), Tone::finding));
    figure(front, "front " + shot.name);
    parts.push_back({front.table()});
    std::string commands;
    for (const PointGroup* group : groupsOf(results, shot))
      for (const Point& point : group->points) commands += point.command + "\n";
    parts.push_back({page::Details{"Commands that repeat one point", {page::Code{commands}}}, ReportPart::kPage});
  }
  return parts;
}

}  // namespace strobe::study
