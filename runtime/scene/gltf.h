// SPDX-License-Identifier: MIT
// glTF 2.0 scenes (.glb, .gltf).
#pragma once

#include "base/files.h"
#include "scene/scene.h"

namespace strobe::scene {

// The file's default scene (else its first, else all of it): meshes, metallic-roughness and unlit materials, textures
// with all levels, cameras, punctual lights (see `moderateLights`), rigid animation. Nodes keep the file's order and
// names (unnamed ones are "node_N"; of equal names the later get "#2", "#3"...). A skinned mesh moves with its joint of
// most weight, unbent; it, morph targets (base mesh) and blended materials (cut-outs) each give a warning.
// Throws `Error` in one line for a file that is missing, cut short, inconsistent, needs an unsupported extension, or
// names a file that lies outside of its own folder, links followed (with `allow_outside` those are read).
Scene loadGltf(const Path& file, bool allow_outside = false);

}  // namespace strobe::scene
