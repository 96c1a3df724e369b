// SPDX-License-Identifier: MIT
// Progress over many pictures of known cost: a moving line on a terminal, one line per picture elsewhere.
#pragma once

#include <unistd.h>

#include <algorithm>

#include "base/log.h"

namespace strobe::lab {

class Pace {
 public:
  Pace(const std::string& label, int pictures, int cost)
      : pictures_(pictures), cost_(cost), started_s_(clockSeconds()), line_(label, cost) {}

  void advance(int by) {
    done_ += by;
    line_.advance(by);
  }

  void finish(const std::string& what) {
    ++finished_;
    if (::isatty(STDERR_FILENO)) return;
    double elapsed_s = clockSeconds() - started_s_;
    double left_s = done_ > 0 ? elapsed_s * std::max(cost_ - done_, 0) / done_ : 0;
    note(fmt::format("{}/{}  {}  ({:.0f} s, about {:.0f} s left)", finished_, pictures_, what, elapsed_s, left_s));
  }

 private:
  int pictures_, cost_, done_ = 0, finished_ = 0;
  double started_s_;
  Progress line_;
};

}  // namespace strobe::lab
