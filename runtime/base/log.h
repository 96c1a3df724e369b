// SPDX-License-Identifier: MIT
// Messages to the user at the terminal, on stderr. Results go to stdout, not through this file.
#pragma once

#include <fmt/format.h>

#include <string>

namespace strobe {

// A line for the user; colours only on a terminal and never when NO_COLOR is set.
void note(const std::string& text);
void warn(const std::string& text);

// Replaces the progress line on a terminal with `label` 12/40, the rate and the time left; prints nothing elsewhere.
class Progress {
 public:
  Progress(std::string label, int total);
  ~Progress();
  void advance(int by = 1);

 private:
  std::string label_;
  int total_;
  int done_ = 0;
  double started_s_;
  double shown_s_ = 0;
};

// Seconds of a monotonic clock; for progress and timings only, never for anything that reaches an image.
double clockSeconds();

}  // namespace strobe
