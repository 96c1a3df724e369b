// SPDX-License-Identifier: MIT
// Memory that a glTF file needs, from its JSON alone.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Throws `Error` with the numbers and the largest need if the file's meshes, morph targets, instances, keys and
// compressed parts need more than 1 GiB and 1000 times the bytes of the file together, or more than is free. A count
// in an accessor is a few bytes of JSON, so a short file could state any amount. Called before anything is
// allocated by such a count.
void requireMemory(const GltfFile& file);

}  // namespace strobe::scene
