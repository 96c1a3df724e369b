// SPDX-License-Identifier: MIT
// What a channel of KHR_animation_pointer drives.
#pragma once

#include <optional>

#include "scene/gltf_file.h"

namespace strobe::scene {

// A transform of a node, or else a property of a camera or light.
struct PointerTarget {
  int node = -1;
  Track::Target target = Track::Target::Translation;
  std::optional<PropertyTrack::Property> property;
  int index = -1;      // of the camera or light
  int components = 3;  // of a value
};

// Nothing for a pointer to what cannot be moved here. Throws `Error` for one to what the file does not have.
std::optional<PointerTarget> pointerTarget(const GltfFile& file, const std::string& pointer, const std::string& where);

}  // namespace strobe::scene
