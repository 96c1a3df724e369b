// SPDX-License-Identifier: MIT
// glTF materials, their textures and samplers.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the materials of the file and their textures to the scene. The last material is the default of primitives
// without a material. Parts that are left out are added to the warnings. Throws `Error` before images are decoded if
// all images together need more than `most_bytes`.
void readMaterials(GltfFile& file, Scene& scene, uint64_t most_bytes);

}  // namespace strobe::scene
