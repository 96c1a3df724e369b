// SPDX-License-Identifier: MIT
// Limits of scenes: contents that are refused, or drawn inexactly.
#pragma once

#include <array>

#include "base/limit.h"

namespace strobe::scene {

inline constexpr Limit kTransformLimit{
    "transforms", Limit::Kind::Refused,
    "a node's transform is not finite, or its position is farther than 1e18 from the camera",
    "nothing is drawn; check the scales and translations of the node and of its ancestors"};
inline constexpr Limit kCoplanarLimit{
    "coplanar", Limit::Kind::Known, "two surfaces coincide, to within the rounding of their depths",
    "only one surface is visible, and raster and rays may disagree on it; at exactly equal depths it is the first "
    "surface of the scene. Move the surfaces apart by 1/100000 of their distance from the camera"};
inline constexpr Limit kLargeMeshLimit{
    "large_mesh", Limit::Kind::Known, "a mesh is more than a million times as large as its visible part",
    "its vertices have single precision: they are rounded to 1/16 millionth of the mesh's size. Split the mesh"};

inline constexpr std::array kLimits = {kTransformLimit, kCoplanarLimit, kLargeMeshLimit};

}  // namespace strobe::scene
