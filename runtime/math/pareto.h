// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace strobe {

// Which points no other dominates, that is: has no larger first and no larger second value, and one smaller. Indices by
// growing first value; of equal points the first. Points with a value that is not finite are left out.
std::vector<size_t> paretoFront(const std::vector<std::pair<double, double>>& points);

}  // namespace strobe
