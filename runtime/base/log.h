// SPDX-License-Identifier: MIT
// Messages to the user at the terminal, on stderr. Results go to stdout, not through this file.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace strobe {

// Prints a line for the user. Colours only on a terminal, and never if NO_COLOR is set.
void note(const std::string& text);
void warn(const std::string& text);

// Status line on a terminal. `show` replaces it at most five times a second; the destructor clears it. Prints nothing
// if stderr is not a terminal.
class StatusLine {
 public:
  ~StatusLine();
  // Calls `text` only if the line is shown.
  template <class Text>
  void show(const Text& text) {
    if (isDue()) print(text());
  }

 private:
  bool isDue();
  void print(const std::string& text);
  double shown_s_ = 0;
};

// Progress over a known number of units, as a status line. The rate is measured from the first report on.
class Progress {
 public:
  Progress(std::string label, int total, std::string unit)
      : label_(std::move(label)), unit_(std::move(unit)), total_(total) {}
  // Reports that `done` units are done, at most the total.
  void reach(int done);
  // "truth 120/256 time samples  41.2/s  3 s left". Without rate and time left during 0.2 s after the first report.
  std::string text(double now_s) const;

 private:
  std::string label_, unit_;
  int total_ = 0, done_ = 0, first_done_ = 0;
  std::optional<double> first_s_;
  StatusLine line_;
};

// Monotonic time, seconds. For progress and timings only: an image must not depend on it.
double clockSeconds();

}  // namespace strobe
