// SPDX-License-Identifier: MIT
// Binary PLY files of meshes.
#pragma once

#include <string>
#include <vector>

#include "scene/bend.h"
#include "scene/scene.h"

namespace strobe::scene {

// Position, normal and texture coordinates (u, v) of each vertex as floats, and triangles. `texture` selects and
// transforms the texture coordinates. `deformed`: vertices that replace the vertices of the geometry, or null.
std::string plyOf(const Geometry& geometry, const TextureUse& texture, const BentVertex* deformed);

}  // namespace strobe::scene
