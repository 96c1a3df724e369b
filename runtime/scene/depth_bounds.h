// SPDX-License-Identifier: MIT
// Motion that blurs between two view depths alone, with soft ends: depth-bounded velocity, as games keep the weapon
// before the camera sharp. Instances keep a share of their motion on the screen, by their depth at the raster time;
// whoever draws the frame has the poses that follow, truth and filters alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace strobe::scene {

struct DepthBounds {
  double near_m = 0, far_m = 0;  // view depths between which all of the motion is kept, 0 <= near_m <= far_m
  double soft_m = 0;             // beyond either, over which none of it comes to be kept; 0: at once

  // "NEAR,FAR" or "NEAR,FAR,SOFT", metres; FAR may be "inf". Throws `Error` (exit code 2).
  static DepthBounds from(const std::string& text);

  // 0 to 1; smooth (Hermite) over the soft ends.
  double shareAt(double depth_m) const;
};

// By instance, the share of its motion that is kept: by the view depth, at the raster time, of the middle of the box
// around it.
std::vector<double> motionShares(const Scene& scene, const Pose& capture, const DepthBounds& bounds);

// The pose at a time in which each instance is, as seen from the camera, where it truly is at capture + share * (time -
// capture). Lights and what has all of its motion stay as `pose_at` has them.
Pose boundedPose(const std::function<Pose(double)>& pose_at, const std::vector<double>& shares, double capture_s,
                 double time_s);

}  // namespace strobe::scene
