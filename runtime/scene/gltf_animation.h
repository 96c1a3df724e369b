// SPDX-License-Identifier: MIT
// glTF animations.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the animations of the file to the scene, whose nodes are read already. Nodes that are animated get their
// transform in parts. What is left out is added to the warnings.
void readAnimations(const GltfFile& file, Scene& scene);

}  // namespace strobe::scene
