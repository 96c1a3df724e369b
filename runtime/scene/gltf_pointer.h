// SPDX-License-Identifier: MIT
// What a channel of KHR_animation_pointer drives.
#pragma once

#include <optional>

#include "scene/gltf_file.h"

namespace strobe::scene {

// A transform of a node, weights of morph targets, or else a property of a camera or light.
struct PointerTarget {
  int node = -1;
  Track::Target target = Track::Target::Translation;
  std::optional<PropertyTrack::Property> property;
  int index = -1;                 // of the camera or light
  int components = 3;             // of a value; of weights how many
  std::vector<int> morphed = {};  // nodes whose weights from `first_weight` it drives
  size_t first_weight = 0;
};

// Nothing for a pointer to what cannot be moved here. Throws `Error` for one to what the file does not have.
std::optional<PointerTarget> pointerTarget(const GltfFile& file, const std::string& pointer, const std::string& where);

// All weights of nodes that have a mesh with as many morph targets. Throws `Error` for a node that has none.
PointerTarget weightsOf(const GltfFile& file, const std::vector<int>& nodes, const std::string& where);

}  // namespace strobe::scene
