// SPDX-License-Identifier: MIT
// Shutter curve: the weight of each time of an exposure, piecewise linear, from shutter open (0) to shutter close (1).
// Samples at `timeOf` of evenly spaced shares have equal weights.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace strobe {

// Piecewise linear weight of the light over an exposure, with its cumulative weight and the inverse for importance
// sampling. Times and cumulative weights are in [0, 1].
class ShutterCurve {
 public:
  // Knot of the curve, measured from one end of the exposure, with the weight up to the next knot.
  struct Knot {
    double distance = 0;  // from that end, as a share of the exposure's length
    double share = 0;     // of the total weight, between that end and the knot
    double weight = 0;    // at the knot; the mean weight over the exposure is 1
    double slope = 0;     // of the weight, up to the next knot
  };
  static constexpr size_t kMostKnots = 64;
  struct Point {
    double time = 0, weight = 0;
  };

  // All times have equal weights.
  ShutterCurve() = default;

  // Reads a curve. Shares are relative to the exposure.
  // - "box", "triangle"
  // - "trapezoid" or "trapezoid:OPENING,CLOSING": shares during which the shutter opens and closes, each at least 0,
  //   with a sum of at most 1; default 0.25 each
  // - "gaussian" or "gaussian:SIGMA": standard deviation as a share, 0.01 to 10; default 1/6. The curve is centred and
  //   cut off at four standard deviations.
  // - "0,1,1,0.5": weights at even distances from shutter open to shutter close
  // - "TIME=WEIGHT,...": times from 0 to 1; two points at one time make a jump
  // Weights are relative. Weights are not negative, and one is positive. Throws `Error` (exit code 2) for other texts.
  static ShutterCurve from(const std::string& text);

  bool isBox() const { return knots_[0].empty(); }

  // Time before which the share of the weight lies; both in [0, 1]. A symmetric curve has 1 - share at 1 - time, to the
  // last bit. If the weights around share 1/2 are 0, timeOf(1/2) is the middle of that interval.
  double timeOf(double share) const;
  // Share of the weight before the time.
  double shareBefore(double time) const;

  // Knots from shutter open (0) or shutter close (1) to the middle of the weight, where `share` is 1/2; at most
  // kMostKnots. Empty for a box. For a symmetric curve, both lists are equal to the last bit.
  const std::vector<Knot>& knotsFrom(int end) const { return knots_[size_t(end)]; }

 private:
  explicit ShutterCurve(const std::vector<Point>& points);
  double distanceOf(int end, double share) const;

  std::array<std::vector<Knot>, 2> knots_;
};

}  // namespace strobe
