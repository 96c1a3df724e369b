// SPDX-License-Identifier: MIT
// Growth of the time of a frame and of its passes: a straight line through the medians of shots that differ in one
// value.
#pragma once

#include <optional>

#include "bench/times.h"
#include "math/effects.h"

namespace strobe::bench {

// Growth of a time with the varied quantity: constant, linear, or linear in the logarithm of the quantity.
enum class Growth { constant, linear, logarithmic };
const char* nameOf(Growth growth);
// Asserts that `name` is the name of a growth.
Growth growthNamed(const std::string& name);

inline constexpr const char* kFrame = "frame";       // part name of the whole frame
inline constexpr const char* kEveryPass = "passes";  // in an expectation: each pass without an expectation of its own

// Expected growth of the time of a part of a frame.
struct ExpectedGrowth {
  std::string part, method;  // method "": every method
  Growth growth = Growth::linear;
  std::string why;
};

// Shots that differ in one value only.
struct AxisRun {
  std::string name, title, unit;
  Run run;
  std::vector<double> x;  // for each shot of the run: amount of the varied quantity, at least 0
  std::vector<ExpectedGrowth> expected;
};

// Largest change of a constant time along an axis, as a share of its mean; smallest R2 of a growing time.
inline constexpr double kConstantShare = 0.1, kLeastR2 = 0.9;

// Outcome of an expectation. Constant time: the 95 % interval of the change along the axis overlaps +- kConstantShare
// of the mean time. Growing time: the interval of the slope is above 0, and R2 is at least kLeastR2.
enum class GrowthVerdict { unknown, holds, fails };  // unknown: no expectation, or fewer than three points
const char* nameOf(GrowthVerdict verdict);

// Line of a part of a method's frames: medians of the rounds over x, or over log2(x) if logarithmic growth is expected.
struct Fit {
  std::string method, part;  // part: kFrame, a pass, kRest
  std::vector<double> x;
  std::vector<Estimate> ms;
  LineFit line;
  std::optional<ExpectedGrowth> expected;
  GrowthVerdict verdict = GrowthVerdict::unknown;

  bool isLogarithmic() const { return expected && expected->growth == Growth::logarithmic; }
  double at(double x) const;  // milliseconds of the line
};

// For each method the frame, then the parts that all its frames have.
std::vector<Fit> fitsOf(const AxisRun& axis);

// Throws `Error` (exit code 2) if an expectation names a part that no frame has.
void requireKnownParts(const AxisRun& axis, const std::vector<Fit>& fits);

Json toJson(const AxisRun& axis, const std::vector<Fit>& fits);

}  // namespace strobe::bench
