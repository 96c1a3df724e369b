// SPDX-License-Identifier: MIT
// The values that a sweep gives to a control: what its declaration suggests, or what was asked for.
#pragma once

#include <string>
#include <vector>

#include "lab/session.h"

namespace strobe::live {

constexpr int kMostOfOne = 16, kMostOfTwo = 8;  // values of a control: alone, and beside another

// Numbers from one end to the other, both included: by the same step, or by the same factor.
struct SweepRange {
  double from = 0, to = 1;
  int steps = 2;
  bool logarithmic = false;
};

struct SweepAxis {
  plan::ParamDesc declaration;
  bool logarithmic = false;
  std::vector<plan::Value> values;  // no two alike
};

// Numbers, switches and choices can be swept, but for what decides nothing that the window shows.
bool canBeSwept(const lab::Control& control);

// Whether a sweep has a range to choose; else it goes through all values there are.
bool hasRange(const plan::ParamDesc& declaration);

// All of a short range; of an endless one what lies around the value. By factors where the ends lie far apart.
SweepRange suggestedRange(const lab::Control& control);

// Whole numbers for integers; of values that come out alike, one. Throws `Error` where the range lies outside of what
// is declared, has a logarithm of nothing, or more than `most` steps.
SweepAxis axisOf(const plan::ParamDesc& declaration, const SweepRange& range, int most = kMostOfOne);
// All values of a switch or choice; of more than `most`, the first and the one it has. The suggested range of a number.
SweepAxis axisOf(const lab::Control& control, int most = kMostOfOne);
// Those listed, as texts. Throws `Error` where one does not fit.
SweepAxis axisOf(const plan::ParamDesc& declaration, const std::vector<std::string>& values);

}  // namespace strobe::live
