// SPDX-License-Identifier: MIT
// Keys of a transform over an exposure, for programs that interpolate translation and scale linearly, and rotation
// along the shorter arc, such as Mitsuba 3, Embree and OptiX.
#pragma once

#include <functional>
#include <vector>

#include "math/geometry.h"

namespace strobe::scene {

// Embree takes at most 129 keys. A path has twice as many intervals, to measure the deviation between keys.
constexpr size_t kMostKeys = 129;
constexpr size_t kPathTimes = 2 * (kMostKeys - 1) + 1;

// True if the transform is not of the form translation * rotation * scale.
bool isSheared(const dmat4& transform);

// Transforms at evenly spaced key times of an exposure, and the largest deviation of their interpolation from the true
// path.
struct Keys {
  std::vector<dmat4> transforms;  // at even times from the first to the last of the path; one: constant
  double deviation = 0;           // largest deviation between keys
};

// Returns the fewest keys, 2^k + 1, with a deviation from the path of at most `most_deviation` and rotations of at most
// 5 degrees between keys. (OptiX interpolates the numbers of quaternions, which then differs from the arc by 0.0002
// degrees.) Returns kMostKeys if fewer are not enough. `path`: kPathTimes transforms. `deviation`: deviation of a
// transform at a time of the path.
Keys keysOf(const std::vector<dmat4>& path, double most_deviation,
            const std::function<double(size_t time, const dmat4&)>& deviation);

}  // namespace strobe::scene
