// SPDX-License-Identifier: MIT
// What a scene in a frame requires, so that what it does not require is not paid for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/frame_poser.h"

namespace strobe::scene {

// Whose camera a frame sees through, and when it poses the scene: at the times of its exposure and at `previous_s`, by
// a `FramePoser`.
struct FrameView {
  int camera_node = -1;
  std::string animation = "all";
  FrameTimes times;
  double previous_s = 0;
  std::optional<bool> camera_moves;  // with time, where something else than the scene moves the camera
};

// Facts of a frame. Conservative: false only if proven false.
struct Facts {
  bool camera_moves = true;  // within the times of the frame: from the first to the last of them
  bool motion = true;        // the camera, a light or anything with triangles moves within them
  std::vector<bool> moves;   // by instance: does it move within them? Empty: each may
  bool alpha = true;         // something with triangles is cut out or blended by its alpha
  bool blend = true;         // something with triangles is blended by its alpha
  bool one_sided = true;     // something with triangles is not seen from behind
  bool shadows = true;       // a light casts shadows
  bool deforms = true;       // joints, morph targets or a flat transform may deform something with triangles
};

// By the keys and rates that drive nodes, not by poses, which are equal at both ends of a motion that returns; and by
// the poses at the four times, which must be equal to the last bit. What the frame keeps no motion of (a share of 0, a
// cut, an exposure of 0 where nothing is asked of the frame before) does not move.
Facts factsOf(const Scene& scene, const FrameView& view);

}  // namespace strobe::scene
