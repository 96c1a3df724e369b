// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/shot_data.h"
#include "math/pareto.h"
#include "page/chart.h"
#include "page/svg.h"
#include "study/gallery.h"
#include "study/layout.h"
#include "study/report.h"

namespace strobe::study {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// A method at a point of a shot.
struct Candidate {
  const PointGroup* group;
  const Point* point;
  double x, y;
};

std::string titleOf(const Measure& measure, const std::string& region) {
  return measure.per_region ? headOf(measure) + ", " + region : headOf(measure);
}

class Front {
 public:
  Front(const Results& results, const ShotSummary& shot, const FrontLayout& layout)
      : results_(results), shot_(shot), layout_(layout), x_(measureNamed(layout.x)), y_(measureNamed(layout.y)) {
    for (const PointGroup* group : groupsOf(results, shot))
      for (const Point& point : group->points) {
        if (point.role != Role::method) continue;
        double x = point.value(layout.x, layout.region), y = point.value(layout.y, layout.region);
        if (std::isfinite(x) && std::isfinite(y)) all_.push_back({group, &point, x, y});
      }
    std::vector<std::pair<double, double>> costs;
    for (const Candidate& one : all_) costs.emplace_back(cost(x_, one.x), cost(y_, one.y));
    for (size_t i : paretoFront(costs)) front_.push_back(&all_[i]);
  }

  bool empty() const { return all_.empty(); }
  page::Chart chart() const;
  page::Table table() const;
  std::string text() const {
    return fmt::format("{} of {} points are on the front: no other point of the shot is as good in both.",
                       front_.size(), all_.size());
  }

 private:
  static double cost(const Measure& measure, double value) { return measure.better == Better::higher ? -value : value; }
  page::Axis axis(const Measure& measure) const {
    page::Axis axis;
    axis.title = titleOf(measure, layout_.region);
    double least = kUnbounded, most = 0;
    for (const Candidate& one : all_) {
      double value = &measure == &x_ ? one.x : one.y;
      least = std::min(least, value), most = std::max(most, value);
    }
    bool wide = least > 0 && most > 5 * least;
    axis.kind = wide && measure.better == Better::lower ? page::Scale::Kind::log : page::Scale::Kind::linear;
    axis.rounded = !wide;
    return axis;
  }

  const Results& results_;
  const ShotSummary& shot_;
  const FrontLayout& layout_;
  const Measure& x_;
  const Measure& y_;
  std::vector<Candidate> all_;
  std::vector<const Candidate*> front_;
};

page::Chart Front::chart() const {
  page::Chart chart;
  chart.x = axis(x_), chart.y = axis(y_);
  chart.about = fmt::format("{}: {} against {} of every method and value; the front is in the table below", shot_.title,
                            chart.y.title, chart.x.title);
  page::Series border;
  border.label = "front", border.style = page::kFrontStyle, border.stepped = true;
  for (const Candidate* one : front_) border.points.push_back({one->x, one->y});
  chart.series.push_back(border);
  int style = 0;
  for (const ArmSummary& arm : results_.arms) {
    if (arm.role != Role::method) continue;
    page::Series series;
    series.label = arm.name, series.style = style++, series.kind = page::Series::Kind::scatter;
    for (const Candidate& one : all_) {
      if (one.point->arm != arm.name) continue;
      page::Point point{one.x, one.y};
      point.tip =
          fmt::format("{}, {}: {}, {}", arm.name, describe(*one.group), shownValue(x_, one.x), shownValue(y_, one.y));
      point.hollow = !one.point->limits.empty();
      series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(series);
  }
  return chart;
}

page::Table Front::table() const {
  page::Table table;
  table.columns = {"method", "values", {titleOf(x_, layout_.region), true}, {titleOf(y_, layout_.region), true}};
  for (const Candidate* one : front_)
    table.add({one->point->arm, describe(*one->group), page::Cell(one->x, shownValue(x_, one->x)),
               page::Cell(one->y, shownValue(y_, one->y))});
  return table;
}

}  // namespace

Parts frontParts(const Results& results) {
  FrontLayout layout = frontOf(results.layout).value();
  Parts parts = {heading(layout.title.empty() ? "Front" : layout.title, 2, "front", Part::kRead),
                 text(layout.note, Tone::plain, Part::kRead)};
  for (const ShotSummary& shot : results.shots) {
    Front front(results, shot, layout);
    if (front.empty()) continue;
    parts.push_back(heading(shot.title, 3, "front-" + lab::fileNameOf(shot.name)));
    parts.push_back(text(front.text(), Tone::finding));
    page::Chart chart = front.chart();
    std::string name = lab::fileNameOf("front " + shot.name);
    parts.push_back(
        {page::Figure{page::svgOf(chart), "Hollow marks: a limit was met.", name, chart.about}, Part::kRead});
    parts.push_back({front.table()});
    std::string commands;
    for (const PointGroup* group : groupsOf(results, shot))
      for (const Point& point : group->points) commands += point.command + "\n";
    parts.push_back({page::Details{"Commands that repeat one point", {page::Code{commands}}}, Part::kPage});
  }
  return parts;
}

}  // namespace strobe::study
