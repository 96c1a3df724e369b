// SPDX-License-Identifier: MIT
// glTF 2.0 scenes (.glb, .gltf).
#pragma once

#include "base/files.h"
#include "scene/scene.h"

namespace strobe::scene {

// Options of loading a glTF scene: access to files outside of its folder, the material variant, and the image memory
// limit in bytes.
struct GltfOptions {
  bool allow_outside = false;
  std::string variant = "";          // variant of KHR_materials_variants; "": the materials that primitives name
  uint64_t most_bytes = UINT64_MAX;  // limit of the memory of images, besides the available memory
};

// Loads the default scene of the file, or its first scene, or all nodes: meshes, metallic-roughness and unlit
// materials, textures with all levels, cameras, punctual lights (see `moderateLights`), skins, morph targets, and
// animation of nodes, weights, lenses and lights. Nodes keep the order and the names of the file. Nodes without a name
// are "node_N"; repeated names get "#2", "#3", ... Throws a one-line `Error` for a file that is missing, cut short or
// inconsistent, that requires an unsupported extension, that has images larger than the available memory, or that names
// a file outside of its own folder, links followed (`allow_outside` permits these). Exit code 2 for an unknown variant.
Scene loadGltf(const Path& file, const GltfOptions& options = {});

}  // namespace strobe::scene
