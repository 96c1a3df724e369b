// SPDX-License-Identifier: MIT
// Limits of scenes: contents that are refused, or drawn inexactly.
#pragma once

#include <array>

#include "base/limit.h"

namespace strobe::scene {

inline constexpr Limit kTransformLimit{
    "transforms", Limit::Kind::Refused, "a node's transform is not finite, or farther from the camera than 1e18",
    "nothing is drawn; look at the scales and translations of it and of the nodes it is in"};
inline constexpr Limit kCoplanarLimit{
    "coplanar", Limit::Kind::Known, "two surfaces lie in one place, to within the rounding of their depths",
    "one of them is seen, and raster and rays may differ as to which; where depths are equal to the last bit the first "
    "in the scene is. Move them apart by 1/100000 of their distance"};
inline constexpr Limit kLargeMeshLimit{
    "large_mesh", Limit::Kind::Known, "a mesh is more than a million times as large as what the picture shows of it",
    "its vertices are single-precision numbers: they are rounded to 1/16 millionth of its size. Split it"};

inline constexpr std::array kLimits = {kTransformLimit, kCoplanarLimit, kLargeMeshLimit};

}  // namespace strobe::scene
