// SPDX-License-Identifier: MIT
// Axis-aligned bounding boxes.
#pragma once

#include <limits>

#include "math/geometry.h"

namespace strobe {

// Axis-aligned box. Empty until the first point is added.
template <class Point>
struct BoundsOf {
  using Number = typename Point::value_type;
  static constexpr Number kInfinity = std::numeric_limits<Number>::infinity();
  Point low = Point(kInfinity), high = Point(-kInfinity);

  void add(const Point& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const BoundsOf& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return !(low.x <= high.x); }
  Point middle() const { return (low + high) * Number(0.5); }
  Number radius() const { return glm::length(high - low) * Number(0.5); }
  // Corner `i`, 0 to 7. Bit 0 selects high.x, bit 1 high.y, bit 2 high.z.
  Point corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
  // Bounds of the transformed box.
  BoundsOf<dvec3> transformed(const dmat4& transform) const {
    BoundsOf<dvec3> result;
    for (int i = 0; i < 8 && !empty(); ++i) result.add(dvec3(transform * dvec4(corner(i), 1)));
    return result;
  }
  bool operator==(const BoundsOf&) const = default;
};

// Axis-aligned box in double precision.
using Bounds = BoundsOf<dvec3>;

}  // namespace strobe
