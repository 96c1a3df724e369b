// SPDX-License-Identifier: MIT
#include "study/watch.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/numbers.h"
#include "math/statistics.h"
#include "study/gallery.h"
#include "study/layout.h"
#include "study/store.h"

namespace strobe::study {

namespace {

constexpr double kReportEvery_s = 10;
constexpr size_t kMostPoints = 6;  // per shot in one report

struct ReportedPoint {
  std::string what;
  double x, y;
};

double cost(const Measure& measure, double value) { return measure.better == Better::higher ? -value : value; }

// Pareto front of a shot, or the points with the best `y` if no point has an `x`.
std::vector<ReportedPoint> bestOf(const std::vector<ReportedPoint>& seen, const Measure& x, const Measure& y) {
  std::vector<ReportedPoint> best;
  std::vector<std::pair<double, double>> costs;
  bool has_x = std::any_of(seen.begin(), seen.end(), [](const ReportedPoint& one) { return std::isfinite(one.x); });
  for (const ReportedPoint& one : seen) costs.emplace_back(has_x ? cost(x, one.x) : 0, cost(y, one.y));
  for (size_t i : paretoFront(costs)) best.push_back(seen[i]);
  return best;
}

}  // namespace

std::string frontSoFar(const Results& results) {
  FrontLayout layout = frontOf(results.layout).value_or(FrontLayout());
  const Measure &x = measureNamed(layout.x), &y = measureNamed(layout.y);
  std::string text;
  for (const ShotSummary& shot : results.shots) {
    std::vector<ReportedPoint> seen;
    for (const PointGroup* group : groupsOf(results, shot))
      for (const Point& point : group->points) {
        double value = point.value(layout.y, layout.region);
        if (point.role != ArmRole::method || !std::isfinite(value)) continue;
        std::string at = describe(*group);
        seen.push_back({point.arm + (at.empty() ? "" : ", " + at), point.value(layout.x, layout.region), value});
      }
    std::vector<ReportedPoint> best = bestOf(seen, x, y);
    if (best.empty()) continue;
    text += fmt::format("best so far, {} ({}, {}):", shot.title, y.title, layout.region);
    for (size_t i = 0; i < std::min(best.size(), kMostPoints); ++i)
      text += fmt::format("{} {} {}{}", i ? ";" : "", best[i].what, shownValue(y, best[i].y),
                          std::isfinite(best[i].x) ? " at " + shownValue(x, best[i].x) : "");
    if (best.size() > kMostPoints) text += fmt::format("; and {} more", best.size() - kMostPoints);
    text += "\n";
  }
  return text;
}

namespace {

// Number of points without truths.
size_t methodPoints(const Results& results) {
  size_t count = 0;
  for (const PointGroup& group : results.groups) count += group.points.size() - 1;
  return count;
}

// Number of different truths; values of an axis may share one truth.
size_t distinctTruths(const Results& results) {
  std::set<std::string> keys;
  for (const PointGroup& group : results.groups)
    if (!group.truth().key.empty()) keys.insert(group.truth().key);
  return keys.size();
}

size_t keptPoints(const Results& results) {
  size_t count = 0;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points)
      count += point.role != ArmRole::truth && !point.isMissing() && point.failed.empty();
  return count;
}

}  // namespace

void announce(const Results& now) {
  if (size_t left = now.missing())
    note(fmt::format("{} and {}; {} left to draw", countText(methodPoints(now), "point"),
                     countText(distinctTruths(now), "truth"),
                     left == 1 ? "1 point is" : fmt::format("{} points are", left)));
}

std::string keptText(const Results& now) {
  const size_t points = methodPoints(now), kept = keptPoints(now);
  if (points == 0) return "";
  return fmt::format("{} of {} {} kept; the same command continues", kept, countText(points, "point"),
                     kept == 1 ? "is" : "are");
}

std::string keptIn(const Path& outline) noexcept {
  std::string kept;
  try {
    Results results = resultsIn(outline);
    takePoints(results, outline.parent_path());
    kept = keptText(results);
  } catch (const std::exception&) {  // outline missing or damaged
  }
  return kept.empty() ? "the same command continues" : kept;
}

void ProgressWatch::begin(const std::string& label, int cost) {
  if (!now_) return;
  label_ = label, cost_ = cost, done_ = quarters_ = 0;
  started_s_ = said_s_ = clockSeconds();
  line_.emplace();
}

std::string ProgressWatch::text() const {
  double elapsed_s = clockSeconds() - started_s_;
  double left_s = done_ > 0 ? elapsed_s * std::max(cost_ - done_, 0) / done_ : 0;
  return fmt::format("{}: {:.0f} %, {:.0f} s, about {:.0f} s left", label_,
                     100.0 * std::min(done_, cost_) / std::max(cost_, 1), elapsed_s, left_s);
}

void ProgressWatch::advance(int cost) {
  if (!now_) return;
  done_ += cost;
  line_->show([this] { return text(); });
  int quarters = int(4 * int64_t(done_) / std::max(cost_, 1));
  bool is_new = quarters > quarters_ && quarters < 4;
  bool terminal = ::isatty(STDERR_FILENO);
  if (!terminal && clockSeconds() - said_s_ > kReportEvery_s) {
    said_s_ = clockSeconds();
    note(text());
  }
  // Short work needs no intermediate reports.
  if (!is_new || clockSeconds() - started_s_ < kReportEvery_s) return;
  quarters_ = quarters;
  std::string front = frontSoFar(now_());
  if (front == front_) return;
  front_ = front;
  if (!front.empty()) note((terminal ? "\r\033[K" : "") + front.substr(0, front.size() - 1));
}

void ProgressWatch::end() {
  if (!now_) return;
  line_.reset();
  if (!::isatty(STDERR_FILENO)) note(text());
}

}  // namespace strobe::study
