// SPDX-License-Identifier: MIT
#include "scene/depth_bounds.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/numbers.h"
#include "math/bounds.h"
#include "scene/bend.h"

namespace strobe::scene {

DepthBounds DepthBounds::from(const std::string& text) {
  DepthBounds bounds;
  if (auto three = numbersIn<double, 3>(text, ',')) bounds = {(*three)[0], (*three)[1], (*three)[2]};
  else if (auto two = numbersIn<double, 2>(text, ',')) bounds = {(*two)[0], (*two)[1], 0};
  else throw Error(fmt::format("--motion-depths '{}': expected NEAR,FAR or NEAR,FAR,SOFT, in metres", text), {}, 2);
  const bool rising = bounds.near_m >= 0 && bounds.far_m >= bounds.near_m;  // false for NaN
  if (!rising || !std::isfinite(bounds.near_m))
    throw Error(fmt::format("--motion-depths '{}': NEAR must be at least 0, and FAR at least NEAR", text), {}, 2);
  if (!(bounds.soft_m >= 0) || !std::isfinite(bounds.soft_m))
    throw Error(fmt::format("--motion-depths '{}': SOFT must be at least 0", text), {}, 2);
  return bounds;
}

double DepthBounds::shareAt(double depth_m) const {
  const double beyond = depth_m < near_m ? near_m - depth_m : depth_m > far_m ? depth_m - far_m : 0;
  if (beyond <= 0) return 1;
  if (!(beyond < soft_m)) return 0;
  const double left = 1 - beyond / soft_m;
  return left * left * (3 - 2 * left);
}

std::vector<double> motionShares(const Scene& scene, const Pose& capture, const DepthBounds& bounds) {
  const dmat4 camera_from_world = glm::inverse(capture.world_from_camera);
  const std::vector<Instance> instances = instancesOf(scene);
  std::vector<double> shares;
  for (size_t i = 0; i < instances.size(); ++i) {
    const Bounds around = posedBounds(scene, instances, i, capture);
    const dvec3 middle = dvec3(camera_from_world * dvec4(around.middle(), 1));
    shares.push_back(around.empty() ? 1 : bounds.shareAt(-middle.z));
  }
  return shares;
}

// Gives an instance the place relative to the camera of `pose` that it has relative to the camera of `own`.
static void place(Pose& pose, const Pose& own, size_t index) {
  pose.world_from_instance[index] = own.world_from_instance[index];
  pose.bends[index] = own.bends[index];
  if (own.world_from_camera == pose.world_from_camera) return;
  const dmat4 along = pose.world_from_camera * glm::inverse(own.world_from_camera);
  std::vector<dmat4>& joints = pose.bends[index].joints;
  if (joints.empty()) pose.world_from_instance[index] = along * pose.world_from_instance[index];
  for (dmat4& joint : joints) joint = along * joint;
}

Pose boundedPose(const std::function<Pose(double)>& pose_at, const std::vector<double>& shares, double raster_s,
                 double time_s) {
  Pose pose = pose_at(time_s);
  std::map<double, Pose> others;  // by share
  for (size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] == 1) continue;
    auto [other, added] = others.try_emplace(shares[i]);
    if (added) other->second = pose_at(raster_s + shares[i] * (time_s - raster_s));
    place(pose, other->second, i);
  }
  return pose;
}

}  // namespace strobe::scene
