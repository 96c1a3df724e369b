// SPDX-License-Identifier: MIT
// glTF materials, their textures and samplers.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the materials of the file and the textures that they use to the scene; behind them, the last, that of primitives
// which name none. What is left out is added to the warnings. Images are refused before any is decoded where all of
// them together need more than `most_bytes`.
void readMaterials(GltfFile& file, Scene& scene, uint64_t most_bytes);

}  // namespace strobe::scene
