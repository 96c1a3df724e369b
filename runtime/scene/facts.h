// SPDX-License-Identifier: MIT
// What a scene in a frame requires, so that what it does not require is not paid for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace strobe::scene {

// Whose camera a frame sees through, and the times at which it poses the scene.
struct FrameView {
  int camera_node = -1;
  std::string animation = "all";
  double capture_s = 0, open_s = 0, close_s = 0, previous_s = 0;
  std::optional<bool> camera_moves;  // within these times, where something else than the scene moves the camera
};

// What a frame has. Each holds unless it surely does not.
struct Facts {
  bool camera_moves = true;  // within the times of the frame: from the first to the last of them
  bool motion = true;        // the camera, a light or anything with triangles moves within them
  std::vector<bool> moves;   // by instance: does it move within them? Empty: each may
  bool alpha = true;         // something with triangles is cut out or blended by its alpha
  bool blend = true;         // something with triangles is blended by its alpha
  bool one_sided = true;     // something with triangles is not seen from behind
  bool shadows = true;       // a light casts shadows
  bool bends = true;         // something with triangles may be bent by joints or morph targets
};

// By the keys and rates that drive nodes, not by poses, which are equal at both ends of a motion that returns; and by
// the poses at the four times, which must be equal to the last bit.
Facts factsOf(const Scene& scene, const FrameView& view);

}  // namespace strobe::scene
