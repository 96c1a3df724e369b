// SPDX-License-Identifier: MIT
// What a scene in a frame requires, so that what it does not require is not paid for.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace strobe::scene {

// Pixels [x0, x1) x [y0, y1).
struct PixelArea {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// The pixels in which anything that moves during [open_s, close_s] can be seen at any time of it; the whole picture
// when the camera moves or a moving object comes near the camera. Bounds of instances are posed at 33 times, and the
// area is widened by the farthest a bound's corner goes in between, so it may only be too large; the whole picture too
// where those times do not show it (turns of more than a right angle in between, many keys, a clip that begins again).
PixelArea reachOfMotion(const Scene& scene, const Camera& camera, const std::function<Pose(double)>& pose_at,
                        double capture_s, double open_s, double close_s, int width, int height);

}  // namespace strobe::scene
