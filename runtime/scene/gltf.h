// SPDX-License-Identifier: MIT
// glTF 2.0 scenes (.glb, .gltf).
#pragma once

#include "base/files.h"
#include "scene/scene.h"

namespace strobe::scene {

struct GltfOptions {
  bool allow_outside = false;
  std::string variant = "";          // a set of materials of KHR_materials_variants, "" for those that primitives name
  uint64_t most_bytes = UINT64_MAX;  // that images may take, where more memory is available
};

// The file's default scene (else its first, else all of it): meshes, metallic-roughness and unlit materials, textures
// with all levels, cameras, punctual lights (see `moderateLights`), skins, morph targets, animation of nodes, weights,
// lenses and lights. Nodes keep the file's order and names (unnamed ones are "node_N"; of equal names the later get
// "#2", "#3"...). Throws `Error` in one line for a file that is missing, cut short, inconsistent, needs an unsupported
// extension, has images that take more memory than is available, or names a file that lies outside of its own folder,
// links followed (with `allow_outside` those are read); exit code 2 for a variant that it does not have.
Scene loadGltf(const Path& file, const GltfOptions& options = {});

}  // namespace strobe::scene
