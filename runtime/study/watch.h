// SPDX-License-Identifier: MIT
// Progress of a running sweep on stderr: share done, time left, and the best points so far.
#pragma once

#include <functional>
#include <optional>

#include "base/log.h"
#include "study/results.h"

namespace strobe::study {

// One line per shot: its Pareto front in the two measures of the front's layout; before times are measured, the points
// with the least error. "" if nothing is measured.
std::string frontSoFar(const Results& results);

// Prints the numbers of points, of truths, and of points left to draw. Prints nothing if all points are drawn.
void announce(const Results& now);

// Text for an interrupted sweep: "7 of 18 points are kept; the same command continues". "" without points.
std::string keptText(const Results& now);

// `keptText` for the points beside an outline. "the same command continues" if the outline is missing or damaged. Does
// not throw.
std::string keptIn(const Path& outline) noexcept;

// Reports progress: a status line on a terminal; elsewhere a line every ten seconds and at the end. Prints the front
// after each quarter of the work.
class ProgressWatch {
 public:
  std::function<Results()> now;  // current results; without, nothing is reported

  // Begins work of `cost` units; `advance` counts them. Reports show the share of finished units.
  void begin(const std::string& label, int cost);
  void advance(int cost);
  void end();

 private:
  std::string text() const;

  std::string label_, front_;  // `front_`: last reported front
  int cost_ = 0, done_ = 0, quarters_ = 0;
  double started_s_ = 0, said_s_ = 0;
  std::optional<StatusLine> line_;
};

}  // namespace strobe::study
