// SPDX-License-Identifier: MIT
// Targets of the channels of KHR_animation_pointer.
#pragma once

#include <optional>

#include "scene/gltf_file.h"

namespace strobe::scene {

// Target of a track. `object` is unused for weights.
struct PointerTarget {
  Track::Target target = Track::Target::Translation;
  int object = -1;                // index of the node, camera or light
  int components = 3;             // components of a value; for weights, their number
  std::vector<int> morphed = {};  // nodes with driven weights, which start at `first_weight`
  size_t first_weight = 0;
};

// Target of a pointer; nothing for a target that cannot be animated. Throws `Error` if the file lacks the target.
std::optional<PointerTarget> pointerTarget(const GltfFile& file, const std::string& pointer, const std::string& where);

// Targets all weights of the nodes. Their meshes have equal numbers of morph targets. Throws `Error` for a node without
// morph targets.
PointerTarget weightsOf(const GltfFile& file, const std::vector<int>& nodes, const std::string& where);

}  // namespace strobe::scene
