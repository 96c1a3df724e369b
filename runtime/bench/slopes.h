// SPDX-License-Identifier: MIT
// How the time of a frame and of its passes follows what a frame has: a straight line through the medians of shots that
// differ in one thing.
#pragma once

#include <optional>

#include "bench/times.h"
#include "math/line.h"

namespace strobe::bench {

enum class Growth { constant, linear, logarithmic };
const char* nameOf(Growth growth);
// Asserts that it is the name of one.
Growth growthNamed(const std::string& name);

inline constexpr const char* kFrame = "frame";       // the part that is all of it
inline constexpr const char* kEveryPass = "passes";  // each that no other expectation names, of an expectation

// How the time of a part of a frame is expected to grow.
struct Expected {
  std::string part, method;  // method "": of each
  Growth growth = Growth::linear;
  std::string why;
};

// Shots that differ in one thing alone.
struct AxisRun {
  std::string name, title, unit;
  Run run;
  std::vector<double> x;  // of each shot of the run: how much of it there is, at least 0
  std::vector<Expected> expected;
};

// What a constant time may change by along an axis, as a share of its mean, and how much of the variation a line has to
// explain where a time grows.
inline constexpr double kConstantShare = 0.1, kLeastR2 = 0.9;

// Whether a time grows as expected. Constant: the 95 % interval of the change along the axis reaches into
// +- kConstantShare of the mean time. Otherwise: the interval of the slope is above 0, and R2 at least kLeastR2.
enum class Verdict { unknown, holds, fails };  // unknown: nothing is expected, or three points are not there
const char* nameOf(Verdict verdict);

// Of a part of a method's frames: the medians of the rounds over x, or over the binary logarithm of x where that is
// expected.
struct Fit {
  std::string method, part;  // part: kFrame, a pass, kRest
  std::vector<double> x;
  std::vector<Estimate> ms;
  Line line;
  std::optional<Expected> expected;
  Verdict verdict = Verdict::unknown;

  bool isLogarithmic() const { return expected && expected->growth == Growth::logarithmic; }
  double at(double x) const;  // the line's milliseconds
};

// Of each method the frame, then the parts that all its frames have.
std::vector<Fit> fitsOf(const AxisRun& axis);

// Throws `Error` (exit code 2) where an expectation is of a part that no frame has: a slip.
void requireKnownParts(const AxisRun& axis, const std::vector<Fit>& fits);

Json toJson(const AxisRun& axis, const std::vector<Fit>& fits);

}  // namespace strobe::bench
