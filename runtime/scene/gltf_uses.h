// SPDX-License-Identifier: MIT
// Uses of the parts of a glTF file, and the formats that each use demands.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Throws `Error` with the place of attributes, indices and keys whose accessors have another format or count, of
// attributes without a meaning, of scenes whose nodes are not roots, and of cameras and images that state two contents.
// Adds a warning for each texture that reads coordinates which its primitive lacks.
void requireUses(const GltfFile& file, std::vector<std::string>& warnings);

}  // namespace strobe::scene
