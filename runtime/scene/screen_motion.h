// SPDX-License-Identifier: MIT
// How what moves goes over the picture within an exposure, as far as bounds of its instances tell.
#pragma once

#include <functional>
#include <vector>

#include "scene/scene.h"

namespace strobe::scene {

// Pixels [x0, x1) x [y0, y1).
struct PixelArea {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// Widens an area to one around both.
void include(PixelArea& area, const PixelArea& other);

// The times of a frame, s, and the size of its picture, px.
struct ExposedFrame {
  double capture_s = 0, open_s = 0, close_s = 0, previous_s = 0;
  int width = 0, height = 0;
  std::vector<double> earlier_s = {};  // captures of frames before the previous one, where a frame looks back so far
};

// Motion of an instance on the screen, within the exposure and back to one frame before the raster time, or to earlier
// frames. Conservative flags: false only if proven false, tolerance 0.05 px.
struct ScreenPath {
  bool curved = true;           // a point leaves the straight line between the ends of its path, or changes its speed
  bool turns = true;            // points of the instance move differently
  bool may_be_occluded = true;  // another object may be in front, or a part of the instance with other motion
};

struct ScreenMotion {
  // The pixels in which anything that moves during [open_s, close_s] can be seen at any time of it, or would be if it
  // went on as since the frame before, or on lines and curves through a few of its poses; the whole picture when the
  // camera moves, a moving object comes near the camera, or the frame looks farther back. Bounds of instances, and of
  // what follows each joint, are posed at 33 times, and the area is widened by the farthest a bound's corner goes in
  // between, so it may only be too large; the whole picture too where those times do not show it (turns of more than a
  // right angle in between, many keys, a clip that begins again).
  PixelArea reach;
  // The same at one of the frame's poses; none: `reach` is all that is known.
  std::function<PixelArea(const Pose&)> area_at;
  std::vector<ScreenPath> paths;  // by instance, from the same poses; all false for a static instance
};

// `pose_at`: the scene at a time, in seconds.
ScreenMotion screenMotionOf(const Scene& scene, const std::function<Pose(double)>& pose_at, const ExposedFrame& frame);

}  // namespace strobe::scene
