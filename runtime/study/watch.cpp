// SPDX-License-Identifier: MIT
#include "study/watch.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "math/pareto.h"
#include "study/gallery.h"
#include "study/layout.h"

namespace strobe::study {

namespace {

constexpr double kReportEvery_s = 10;
constexpr size_t kMostPoints = 6;  // of a shot, in one report

struct Seen {
  std::string what;
  double x, y;
};

double cost(const Measure& measure, double value) { return measure.better == Better::higher ? -value : value; }

// The best of a shot: by both measures, or by `y` alone where nothing has an `x`.
std::vector<Seen> bestOf(const std::vector<Seen>& seen, const Measure& x, const Measure& y) {
  std::vector<Seen> best;
  std::vector<std::pair<double, double>> costs;
  bool has_x = std::any_of(seen.begin(), seen.end(), [](const Seen& one) { return std::isfinite(one.x); });
  for (const Seen& one : seen) costs.emplace_back(has_x ? cost(x, one.x) : 0, cost(y, one.y));
  for (size_t i : paretoFront(costs)) best.push_back(seen[i]);
  return best;
}

}  // namespace

std::string frontSoFar(const Results& results) {
  FrontLayout layout = frontOf(results.layout).value_or(FrontLayout());
  const Measure &x = measureNamed(layout.x), &y = measureNamed(layout.y);
  std::string text;
  for (const ShotSummary& shot : results.shots) {
    std::vector<Seen> seen;
    for (const PointGroup* group : groupsOf(results, shot))
      for (const Point& point : group->points) {
        double value = point.value(layout.y, layout.region);
        if (point.role != Role::method || !std::isfinite(value)) continue;
        std::string at = describe(*group);
        seen.push_back({point.arm + (at.empty() ? "" : ", " + at), point.value(layout.x, layout.region), value});
      }
    std::vector<Seen> best = bestOf(seen, x, y);
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

void announce(const Results& now) {
  size_t points = 0;
  for (const PointGroup& group : now.groups) points += group.points.size() - 1;
  if (size_t left = now.missing())
    note(fmt::format("{} points and {} truths; {} points are left to draw", points, now.groups.size(), left));
}

void Watch::begin(const std::string& label, int cost) {
  if (!now_) return;
  label_ = label, cost_ = cost, done_ = quarters_ = 0;
  started_s_ = said_s_ = clockSeconds();
  line_ = std::make_unique<Progress>(label, cost);
}

void Watch::report() {
  double elapsed_s = clockSeconds() - started_s_;
  double left_s = done_ > 0 ? elapsed_s * std::max(cost_ - done_, 0) / done_ : 0;
  said_s_ = clockSeconds();
  note(fmt::format("{}: {:.0f} %, {:.0f} s, about {:.0f} s left", label_, 100.0 * done_ / std::max(cost_, 1), elapsed_s,
                   left_s));
}

void Watch::advance(int cost) {
  if (!now_) return;
  done_ += cost;
  line_->advance(cost);
  int quarters = int(4 * int64_t(done_) / std::max(cost_, 1));
  bool is_new = quarters > quarters_ && quarters < 4;
  double waited_s = clockSeconds() - said_s_;
  bool terminal = ::isatty(STDERR_FILENO);
  if (!terminal && waited_s > kReportEvery_s) report();
  // What is over in a moment needs no reports on the way.
  if (!is_new || clockSeconds() - started_s_ < kReportEvery_s) return;
  quarters_ = quarters;
  std::string front = frontSoFar(now_());
  if (front == front_) return;
  front_ = front;
  if (!front.empty()) note((terminal ? "\r\033[K" : "") + front.substr(0, front.size() - 1));
}

void Watch::end() {
  if (!now_) return;
  line_.reset();
  if (!::isatty(STDERR_FILENO)) report();
}

}  // namespace strobe::study
