// SPDX-License-Identifier: MIT
// Motion of instances over the picture within an exposure, computed from their bounds.
#pragma once

#include <functional>
#include <vector>

#include "scene/frame_poser.h"

namespace strobe::scene {

// Pixels [x0, x1) x [y0, y1).
struct PixelArea {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// Extends `area` to contain `other`.
void include(PixelArea& area, const PixelArea& other);

// Motion of an instance on the screen, within the exposure and back to the raster time of the previous frame or of
// earlier frames. Conservative flags: false only if proven false, tolerance 0.05 px.
struct ScreenPath {
  bool curved = true;           // a point leaves the straight line between the ends of its path, or changes its speed
  bool turns = true;            // points of the instance move differently
  bool may_be_occluded = true;  // another object may be in front, or a part of the instance with other motion
};

// Bounds of the screen-space motion in one frame: a pixel rectangle around all moving objects, and properties of the
// path of each instance.
struct ScreenMotion {
  // Moving rectangle: the pixels that a moving object may cover at any time of [open_s, close_s]. The rectangle
  // includes the motion extrapolated from the previous frame, and lines and curves through a few poses of the object.
  // Bounds of instances and of joints are posed at 33 times. The area is widened by the largest distance that a corner
  // of the bounds moves between two times, so it may only be too large. The area is the whole picture if the camera
  // moves, a moving object comes near the camera, or the frame uses earlier frames. It is also the whole picture if
  // these times do not show the motion (turns of more than a right angle between two times, many keys, a clip that
  // repeats).
  PixelArea moving_rect;
  // Pixels of all moving objects at one of the frame's poses. If empty, only `moving_rect` is available.
  std::function<PixelArea(const Pose&)> area_at;
  std::vector<ScreenPath> paths;  // by instance, from the same poses; all flags are false for a static instance
};

// `pose_at`: the scene at a time, s.
ScreenMotion screenMotionOf(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame);

}  // namespace strobe::scene
