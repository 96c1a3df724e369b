// SPDX-License-Identifier: MIT
// Attachment of a scene to a node of another scene, such as a glTF file.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// A scene to attach to nodes of another scene, which has its meshes, materials and textures from these indices on.
struct AttachedPart {
  Scene scene;
  int first_mesh = 0, first_material = 0, first_texture = 0;
};

// Adds the meshes, materials and textures of a part to a scene, once for all nodes that the part is attached to.
AttachedPart addedPart(Scene part, Scene& scene);

// Adds a part below `node` of the scene that has its meshes. The node takes over the cuts of the part. The names of the
// part's nodes, clips, cameras and lights get the prefix "NAME/", where NAME is the name of `node`. `animation` chooses
// clips: "all", "none" or a name. Throws `Error` for an unknown clip.
void attach(const AttachedPart& added, int node, const std::string& animation, Scene& scene);

}  // namespace strobe::scene
