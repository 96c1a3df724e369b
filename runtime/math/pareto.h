// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace strobe {

// Indices of the points that no other point dominates, by ascending first value; the first of equal points. A point
// dominates another one if neither of its values is larger and one is smaller. Points with a value that is not finite
// are left out.
std::vector<size_t> paretoFront(const std::vector<std::pair<double, double>>& points);

}  // namespace strobe
