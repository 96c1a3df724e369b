// SPDX-License-Identifier: MIT
// Facts of a frame: the features that its scene uses. Work for other features is skipped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/frame_poser.h"

namespace strobe::scene {

// Facts of a frame. Conservative: false only if proven false.
struct Facts {
  bool camera_moves = true;  // between the first and the last time of the frame
  bool motion = true;        // the camera, a light or an instance with triangles moves in that interval
  std::vector<bool> moves;   // by instance: true if it may move in that interval; empty: all may
  bool alpha = true;         // an instance with triangles is cut out or blended by its alpha
  bool blend = true;         // an instance with triangles is blended by its alpha
  bool one_sided = true;     // an instance with triangles is not visible from behind
  bool shadows = true;       // a light casts shadows
  bool deforms = true;       // joints, morph targets or a flat transform may deform an instance with triangles
};

// Computes the facts from the keys and rates that drive nodes, since poses are equal at both ends of a motion that
// returns; and from the poses at the four times, which must be equal to the last bit. Motion that the frame does not
// keep does not count: a share of 0, a cut, or an exposure of 0 without use of the previous frame.
// `camera_moves`: set for a camera that the scene does not move; true if the camera moves.
Facts factsOf(const FramePoser& poser, std::optional<bool> camera_moves = {});

}  // namespace strobe::scene
