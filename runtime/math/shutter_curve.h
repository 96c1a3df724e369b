// SPDX-License-Identifier: MIT
// How much the times of an exposure count: a weight over the time from the opening of the shutter (0) to its closing
// (1), piecewise linear. Whoever takes samples at `timeOf` of even shares has samples that count alike.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace strobe {

class ShutterCurve {
 public:
  // The weight from one knot on, as counted from one end of the exposure.
  struct Knot {
    double distance = 0;  // from that end, share of the exposure's length
    double share = 0;     // of all weight, from that end to here
    double weight = 0;    // here; its mean over the exposure is 1
    double slope = 0;     // of the weight, up to the next knot
  };
  static constexpr size_t kMostKnots = 64;
  struct Point {
    double time = 0, weight = 0;
  };

  // All times count alike.
  ShutterCurve() = default;

  // "box"; "triangle"; "trapezoid", "trapezoid:OPENING,CLOSING" (shares of the exposure during which the shutter opens
  // and closes, 0 to 1 together; 0.25 each); "gaussian", "gaussian:SIGMA" (standard deviation as a share of the
  // exposure, 0.01 to 10; 1/6), about its middle, cut off four of them away; weights "0,1,1,0.5" at even distances from
  // the opening to the closing; "TIME=WEIGHT,..." from 0 to 1, two of one time for a jump. Weights are relative, none
  // below 0, one above. Throws `Error` (exit code 2).
  static ShutterCurve from(const std::string& text);

  bool isBox() const { return knots_[0].empty(); }

  // The time before which the share lies, both in [0, 1]. Of a curve that is its own mirror image 1 - share is at 1 -
  // time, to the last bit. Where nothing counts in between, the middle of that.
  double timeOf(double share) const;
  // The share before the time.
  double shareBefore(double time) const;

  // From the opening (0) or the closing (1) to the middle of the weight, where `share` is 1/2: at most kMostKnots. None
  // of a box. The two of a curve that is its own mirror image are alike to the last bit.
  const std::vector<Knot>& knotsFrom(int end) const { return knots_[size_t(end)]; }

 private:
  explicit ShutterCurve(const std::vector<Point>& points);
  double distanceOf(int end, double share) const;

  std::array<std::vector<Knot>, 2> knots_;
};

}  // namespace strobe
