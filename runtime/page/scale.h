// SPDX-License-Identifier: MIT
// Scale of an axis: positions of values and ticks.
#pragma once

#include <string>
#include <vector>

namespace strobe::page {

// Tick of a chart axis: position from 0 to 1 along the axis, and label.
struct Tick {
  double at = 0;      // position, 0 to 1 along the axis
  std::string label;  // "" for a small tick
};

// Maps the values of an axis to positions from 0 to 1. A logarithmic scale with a value of 0 shows 0 first, then a gap.
// An even scale has equal distances between neighbouring values, from one end to the other. A scale of slots gives each
// value a slot of the same width, with the value in the middle.
class Scale {
 public:
  enum class Kind { log, linear, even, slots };

  // Covers the smallest to the largest of `values`. Ignores values that are not finite and, on a logarithmic scale,
  // negative values. With `rounded`, a logarithmic scale ends at 1, 3 or 10 times a power of ten, a linear scale at
  // ticks.
  Scale(Kind kind, const std::vector<double>& values, bool rounded = false);

  double at(double value) const;  // 0 to 1, clamped to the axis
  std::vector<Tick> ticks() const;
  bool hasZero() const { return zero_; }
  // Start of the positive values, 0 to 1 along the axis.
  double gap() const;
  // Width of a slot, 0 to 1 along the axis; 0 for other kinds.
  double slot() const;

 private:
  bool isListed() const { return kind_ == Kind::even || kind_ == Kind::slots; }
  double niceStep() const;
  std::vector<Tick> logTicks() const;
  std::vector<Tick> linearTicks() const;

  Kind kind_;
  std::vector<double> values_;  // of an even scale and of slots: ascending, without duplicates
  double low_ = 0, high_ = 1;   // base-10 exponents for a logarithmic scale
  double step_ = 1;             // distance of the ticks of a linear scale
  bool zero_ = false;
};

}  // namespace strobe::page
