// SPDX-License-Identifier: MIT
// glTF skins and weights of morph targets.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the skins of the file to the scene, whose meshes and nodes are read already, and gives nodes their skin and
// weights. Throws `Error` where a mesh follows joints that its skin does not have, or none.
void readSkins(const GltfFile& file, Scene& scene);

// Finds the `sole_joint` of all nodes. Animations are read already.
void findSoleJoints(Scene& scene);

// How many morph targets a mesh of the file has.
size_t targetsOf(const GltfFile& file, int mesh);

// Takes weights away that never count: 0 at rest, and driven by nothing.
void dropIdleWeights(Scene& scene);

}  // namespace strobe::scene
