// SPDX-License-Identifier: MIT
// Memory that a glTF file needs, computed from its JSON alone.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Throws `Error` with the numbers and the largest need if the meshes, morph targets, instances, keys and compressed
// parts of the file together need more than 1 GiB plus 1000 times the bytes of the file, or more than is available. A
// count in an accessor is a few bytes of JSON, so a short file may state any amount. Called before memory is allocated
// by such a count.
void requireMemory(const GltfFile& file);

}  // namespace strobe::scene
