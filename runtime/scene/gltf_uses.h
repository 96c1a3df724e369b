// SPDX-License-Identifier: MIT
// Uses of the parts of a glTF file, and the formats that each use requires.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Throws `Error` with the place for these errors: an accessor of an attribute, of indices or of keys has another format
// or count; an attribute has no meaning; a node of a scene is not a root; a camera or an image states two contents.
// Adds a warning for each texture with coordinates that its primitive lacks.
void requireUses(const GltfFile& file, std::vector<std::string>& warnings);

}  // namespace strobe::scene
