// SPDX-License-Identifier: MIT
// glTF animations.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the animations of the file to a scene with its nodes. Animated nodes get translation, rotation and scale in
// place of a matrix. Parts that are left out are added to the warnings.
void readAnimations(const GltfFile& file, Scene& scene);

}  // namespace strobe::scene
