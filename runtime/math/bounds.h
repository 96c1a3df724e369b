// SPDX-License-Identifier: MIT
// Axis-aligned bounding boxes.
#pragma once

#include <cmath>

#include "math/geometry.h"

namespace strobe {

// Axis-aligned box. Empty until the first point is added.
struct Bounds {
  dvec3 low = dvec3(HUGE_VAL), high = dvec3(-HUGE_VAL);

  void add(const dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return !(low.x <= high.x); }
  dvec3 middle() const { return (low + high) * 0.5; }
  double radius() const { return glm::length(high - low) * 0.5; }
  // Corner `i`, 0 to 7. Bit 0 selects high.x, bit 1 high.y, bit 2 high.z.
  dvec3 corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
  // Bounds of the transformed box.
  Bounds transformed(const dmat4& transform) const {
    Bounds result;
    for (int i = 0; i < 8 && !empty(); ++i) result.add(dvec3(transform * dvec4(corner(i), 1)));
    return result;
  }
};

}  // namespace strobe
