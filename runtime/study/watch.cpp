// SPDX-License-Identifier: MIT
#include "study/watch.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "study/gallery.h"
#include "study/store.h"

namespace strobe::study {

namespace {

constexpr double kReportEvery_s = 10;
constexpr size_t kMostPoints = 6;  // per shot in one report

}  // namespace

std::string frontSoFar(const Results& results) {
  FrontLayout layout = results.layout.front.value_or(FrontLayout());
  const Measure &x = measureNamed(layout.x), &y = measureNamed(layout.y);
  std::string text;
  for (const ShotSummary& shot : results.shots) {
    std::vector<FrontPoint> best = frontOf(frontPoints(results, shot, layout), layout);
    if (best.empty()) continue;
    text += fmt::format("best so far, {} ({}, {}):", shot.title, y.title, layout.region);
    for (size_t i = 0; i < std::min(best.size(), kMostPoints); ++i)
      text += fmt::format("{} {}{} {}{}", i ? ";" : "", best[i].point->arm, afterComma(describe(*best[i].group)),
                          shownValue(y, best[i].y), std::isfinite(best[i].x) ? " at " + shownValue(x, best[i].x) : "");
    if (best.size() > kMostPoints) text += fmt::format("; and {} more", best.size() - kMostPoints);
    text += "\n";
  }
  return text;
}

namespace {

size_t keptPoints(const Results& results) {
  size_t count = 0;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points) count += point.role != ArmRole::truth && point.isDrawn();
  return count;
}

}  // namespace

void announce(const Results& now) {
  if (size_t left = now.missing())
    note(fmt::format("{} and {}; {} left to draw", countText(now.points(), "point"), countText(now.truths(), "truth"),
                     left == 1 ? "1 point is" : fmt::format("{} points are", left)));
}

std::string keptText(const Results& now) {
  const size_t points = now.points(), kept = keptPoints(now);
  if (points == 0) return "";
  return fmt::format("{} of {} {} kept; the same command continues", kept, countText(points, "point"),
                     kept == 1 ? "is" : "are");
}

std::string keptIn(const Path& outline) noexcept {
  std::string kept;
  try {
    kept = keptText(resultsSoFar(outline));
  } catch (const std::exception&) {  // outline missing or damaged
  }
  return kept.empty() ? "the same command continues" : kept;
}

void ProgressWatch::begin(const std::string& label, int cost) {
  if (!now) return;
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
  if (!now) return;
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
  std::string front = frontSoFar(now());
  if (front == front_) return;
  front_ = front;
  if (!front.empty()) note((terminal ? "\r\033[K" : "") + front.substr(0, front.size() - 1));
}

void ProgressWatch::end() {
  if (!now) return;
  line_.reset();
  if (!::isatty(STDERR_FILENO)) note(text());
}

}  // namespace strobe::study
