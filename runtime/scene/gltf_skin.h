// SPDX-License-Identifier: MIT
// glTF skins and weights of morph targets.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Adds the skins of the file to a scene with its meshes and nodes, and sets the skin and the weights of nodes. Throws
// `Error` if a mesh with a skin has no joints, or follows a joint that its skin lacks.
void readSkins(const GltfFile& file, Scene& scene);

// Sets the `sole_joint` of all nodes. The animations must be read already.
void findSoleJoints(Scene& scene);

// Number of morph targets of a mesh of the file.
size_t targetsOf(const GltfFile& file, int mesh);

// Removes weights without an effect: 0 at rest, and not driven.
void dropIdleWeights(Scene& scene);

}  // namespace strobe::scene
