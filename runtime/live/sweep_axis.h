// SPDX-License-Identifier: MIT
// Values of a control in a sweep: suggested by the control's declaration, given by a range, or listed.
#pragma once

#include <string>
#include <vector>

#include "lab/session.h"

namespace strobe::live {

constexpr int kMostOfOne = 16, kMostOfTwo = 8;  // maximum number of values: of one control, and of each of two

// Numbers from one end to the other, both included, in equal steps or by equal factors.
struct SweepRange {
  double from = 0, to = 1;
  int steps = 2;
  bool logarithmic = false;
};

// Axis of a parameter sweep: the declaration of a control and the values to draw on a linear or logarithmic scale,
// without duplicates.
struct SweepAxis {
  plan::ParamDesc declaration;
  bool logarithmic = false;
  std::vector<plan::Value> values;  // without duplicates
};

// True if the control can be swept: a number, switch or choice with an effect on the window's picture.
bool canBeSwept(const lab::Control& control);

// True if a sweep of the control has a range to choose. Otherwise the sweep has all possible values.
bool hasRange(const plan::ParamDesc& declaration);

// Suggested range: the whole declared range if it is narrow, otherwise a range around the current value. Logarithmic if
// the ends are far apart.
SweepRange suggestedRange(const lab::Control& control);

// Axis of a range. Integers are rounded, and duplicates are dropped. Throws `Error` if the range is empty or exceeds
// the declared range, if a logarithmic range has an end of 0 or less, or if the steps are fewer than 2 or more than
// `most`.
SweepAxis axisOf(const plan::ParamDesc& declaration, const SweepRange& range, int most = kMostOfOne);
// Axis of all values of a switch or choice, or of the suggested range of a number. A choice with more than `most`
// values is reduced to the first values and the current one.
SweepAxis axisOf(const lab::Control& control, int most = kMostOfOne);
// Axis of listed values. Throws `Error` if a value does not fit the declaration.
SweepAxis axisOf(const plan::ParamDesc& declaration, const std::vector<std::string>& values);

}  // namespace strobe::live
