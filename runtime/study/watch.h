// SPDX-License-Identifier: MIT
// What a sweep reports on stderr while it runs: how much is done, the time left, and the best points so far.
#pragma once

#include <functional>
#include <memory>

#include "base/log.h"
#include "study/results.h"

namespace strobe::study {

// A line for each shot: the points than which no other has less of both measures of the layout's front, as far as they
// are known; before anything is timed the points with the least error. "" where nothing is measured.
std::string frontSoFar(const Results& results);

// How many points there are and how many are left to draw; nothing where none is.
void announce(const Results& now);

// On a terminal a line that moves; elsewhere a line every ten seconds and at the end. After each quarter of the work
// the front so far.
class Watch {
 public:
  // `now`: the results as far as they are there; without it nothing is reported.
  explicit Watch(std::function<Results()> now) : now_(std::move(now)) {}

  // Work of `cost` units begins; `advance` counts them.
  void begin(const std::string& label, int cost);
  void advance(int cost);
  void end();

 private:
  void report();

  std::function<Results()> now_;
  std::string label_, front_;  // `front_`: the front of the last report
  int cost_ = 0, done_ = 0, quarters_ = 0;
  double started_s_ = 0, said_s_ = 0;
  std::unique_ptr<Progress> line_;
};

}  // namespace strobe::study
