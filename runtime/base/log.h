// SPDX-License-Identifier: MIT
// Messages to the user at the terminal, on stderr. Results go to stdout, not through this file.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace strobe {

// A line for the user; colours only on a terminal and never when NO_COLOR is set.
void note(const std::string& text);
void warn(const std::string& text);

// A line on a terminal that each `show` replaces, at most five times a second; cleared at its end. Nothing elsewhere.
class StatusLine {
 public:
  ~StatusLine();
  // `text` is called when the line is shown.
  template <class Text>
  void show(const Text& text) {
    if (isDue()) print(text());
  }

 private:
  bool isDue();
  void print(const std::string& text);
  double shown_s_ = 0;
};

// Progress over a known number of units as a status line. The rate is measured from the first report on.
class Progress {
 public:
  Progress(std::string label, int total, std::string unit)
      : label_(std::move(label)), unit_(std::move(unit)), total_(total) {}
  // So many units are done, at most the total.
  void reach(int done);
  // "truth 120/256 time samples  41.2/s  3 s left". Without rate and time left within a fifth of a second of the
  // first report.
  std::string text(double now_s) const;

 private:
  std::string label_, unit_;
  int total_ = 0, done_ = 0, first_done_ = 0;
  std::optional<double> first_s_;
  StatusLine line_;
};

// Seconds of a monotonic clock; for progress and timings only, never for anything that reaches an image.
double clockSeconds();

}  // namespace strobe
