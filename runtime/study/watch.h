// SPDX-License-Identifier: MIT
// What a sweep reports on stderr while it runs: how much is done, the time left, and the best points so far.
#pragma once

#include <functional>
#include <optional>

#include "base/log.h"
#include "study/results.h"

namespace strobe::study {

// A line for each shot: the points than which no other has less of both measures of the layout's front, as far as they
// are known; before anything is timed the points with the least error. "" where nothing is measured.
std::string frontSoFar(const Results& results);

// Prints the numbers of points, of truths, and of points left to draw; nothing if all are drawn.
void announce(const Results& now);

// "7 of 18 points are kept; the same command continues", of a sweep that ends before its end. "" where nothing is known
// of its points.
std::string keptText(const Results& now);

// The same for the points beside an outline. "the same command continues" if the outline is missing or damaged. Does
// not throw.
std::string keptIn(const Path& outline) noexcept;

// On a terminal a status line; elsewhere a line every ten seconds and at the end. After each quarter of the work
// the front so far.
class Watch {
 public:
  // `now`: the results as far as they are there; without it nothing is reported.
  explicit Watch(std::function<Results()> now) : now_(std::move(now)) {}

  // Begins work of `cost` units, counted by `advance`. The share of them that is done is shown.
  void begin(const std::string& label, int cost);
  void advance(int cost);
  void end();

 private:
  std::string text() const;

  std::function<Results()> now_;
  std::string label_, front_;  // `front_`: the front of the last report
  int cost_ = 0, done_ = 0, quarters_ = 0;
  double started_s_ = 0, said_s_ = 0;
  std::optional<StatusLine> line_;
};

}  // namespace strobe::study
