// SPDX-License-Identifier: MIT
// Where a value lies along an axis, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace strobe::page {

struct Tick {
  double at = 0;      // 0 to 1 along the axis
  std::string label;  // "" for a small tick
};

// On a logarithmic scale 0 has a place of its own, before a gap, where any of the values is 0. On an even one each
// value is as far from the next, from one end to the other; on one of slots each has a slot of the same width and lies
// in its middle.
class Scale {
 public:
  enum class Kind { log, linear, even, slots };

  // Reaches from the smallest to the largest of `values`; numbers that are not finite count for nothing, and nor do
  // those below 0 on a logarithmic scale. With `rounded`, a logarithmic scale reaches to 1, 3 or 10 times a power of
  // ten on both sides, a linear one to ticks.
  Scale(Kind kind, const std::vector<double>& values, bool rounded = false);

  double at(double value) const;  // 0 to 1, clamped to the axis
  std::vector<Tick> ticks() const;
  bool hasZero() const { return zero_; }
  // Where what is above zero begins.
  double gap() const;
  // Of slots: the width of one. 0 otherwise.
  double slot() const;

 private:
  bool isListed() const { return kind_ == Kind::even || kind_ == Kind::slots; }
  double niceStep() const;
  std::vector<Tick> logTicks() const;
  std::vector<Tick> linearTicks() const;

  Kind kind_;
  std::vector<double> values_;  // of an even scale and of slots: ascending, each once
  double low_ = 0, high_ = 1;   // powers of ten of a logarithmic scale
  double step_ = 1;             // between ticks of a linear scale
  bool zero_ = false;
};

}  // namespace strobe::page
