// SPDX-License-Identifier: MIT
// Depth-bounded velocity: motion blurs only between two view depths, with soft ends. Games keep the weapon in front of
// the camera sharp this way. Each instance keeps a share of its screen motion, by its depth at the raster time. Ground
// truth and filters draw the same poses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace strobe::scene {

// Interval of view depths with full motion blur, and the width of the soft transition beyond both ends, in metres.
struct DepthBounds {
  double near_m = 0, far_m = 0;  // view depths between which all motion is kept, 0 <= near_m <= far_m
  double soft_m = 0;             // width of the soft ends beyond these depths; the share falls there from 1 to 0

  // "NEAR,FAR" or "NEAR,FAR,SOFT", metres; FAR may be "inf". Throws `Error` (exit code 2).
  static DepthBounds from(const std::string& text);

  // Share of the motion at a depth, 0 to 1; smooth (Hermite) over the soft ends.
  double shareAt(double depth_m) const;
};

// Share of its motion that each instance keeps, by the view depth of the middle of its bounds at the raster time.
std::vector<double> motionShares(const Scene& scene, const Pose& capture, const DepthBounds& bounds);

// Pose at `time_s` with shares of motion. Relative to the camera, each instance has its true pose of the time raster_s
// + share * (time_s - raster_s). Lights, and instances with share 1, are as in `pose_at`.
Pose boundedPose(const std::function<Pose(double)>& pose_at, const std::vector<double>& shares, double raster_s,
                 double time_s);

}  // namespace strobe::scene
