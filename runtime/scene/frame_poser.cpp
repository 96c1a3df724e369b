// SPDX-License-Identifier: MIT
#include "scene/frame_poser.h"

#include <algorithm>

#include "base/lists.h"
#include "scene/motion.h"

namespace strobe::scene {

FramePoser::FramePoser(const Scene& scene, int camera_node, const std::string& animation, const FrameView& view)
    : scene_(scene),
      camera_node_(camera_node),
      animation_(animation),
      poser_(scene, camera_node, animation),
      view_(view) {
  NodeTime everything{Clock::Objects, scene.cuts, {}};
  everything.add({Clock::Objects, view.cuts, {}});
  std::vector<NodeTime> nodes(scene.nodes.size());
  addClips(nodes);
  for (int index : hierarchyOrder(scene)) {
    const Node& node = scene.nodes[size_t(index)];
    NodeTime& own = nodes[size_t(index)];
    const NodeTime& above = node.parent >= 0 ? nodes[size_t(node.parent)] : everything;
    own.clock = above.clock;
    own.add(above);
    own.add({Clock::Objects, node.cuts, {}});
    if (index == view.followed) own.clock = Clock::Camera;
  }
  for (const Instance& instance : instancesOf(scene)) instances_.push_back(ofInstance(instance, nodes));
  for (int light : lightsOf(scene)) lights_.push_back(nodes[size_t(light)]);
  if (camera_node >= 0) camera_ = nodes[size_t(camera_node)];
  else camera_ = everything;
  camera_.clock = Clock::Camera;
}

void FramePoser::NodeTime::add(const NodeTime& other) {
  cuts.insert(cuts.end(), other.cuts.begin(), other.cuts.end());
  for (const Animation* clip : other.clips) addOnce(clips, clip);
}

// Adds the clips that have cuts to the nodes that they drive, directly or by a camera, a light or weights.
void FramePoser::addClips(std::vector<NodeTime>& nodes) const {
  for (const Animation* clip : clipsOf(scene_, animation_)) {
    if (clip->cuts.empty()) continue;
    const NodeTime its{Clock::Objects, {}, {clip}};
    for (const Track& track : clip->tracks) {
      if (track.isOfNode()) nodes[size_t(track.object)].add(its);
      for (size_t i = 0; i < nodes.size() && !track.isOfNode(); ++i)
        if ((track.isOfCamera() ? scene_.nodes[i].camera : scene_.nodes[i].light) == track.object) nodes[i].add(its);
    }
  }
}

// A mesh with a skin also follows the joints.
FramePoser::NodeTime FramePoser::ofInstance(const Instance& instance, const std::vector<NodeTime>& nodes) const {
  NodeTime time = nodes[size_t(instance.node)];
  const Node& node = scene_.nodes[size_t(instance.node)];
  if (node.skin < 0) return time;
  for (int joint : scene_.skins[size_t(node.skin)].joints) {
    const NodeTime& other = nodes[size_t(joint)];
    if (other.clock == Clock::Camera) time.clock = Clock::Camera;
    time.add(other);
  }
  return time;
}

bool FramePoser::isCut(const NodeTime& node, double from_s, double to_s) const {
  if (comesToACut(node.cuts, from_s, to_s)) return true;
  return std::any_of(node.clips.begin(), node.clips.end(),
                     [&](const Animation* clip) { return comesToACut(*clip, from_s, to_s); });
}

// A frame with a cut in its exposure is static, on the raster time's side of the cut. Other poses of the frame are held
// at the raster time only if a cut is between them and the raster time.
double FramePoser::timeOf(const NodeTime& node, double time_s) const {
  const double raster_s = view_.raster_s;
  if (isCut(node, std::min(view_.open_s, raster_s), std::max(view_.close_s, raster_s))) return raster_s;
  if (isCut(node, std::min(time_s, raster_s), std::max(time_s, raster_s))) return raster_s;
  const double share = node.clock == Clock::Camera ? view_.camera_share : view_.object_share;
  return share == 1 ? time_s : raster_s + share * (time_s - raster_s);
}

const Pose& FramePoser::posed(double time_s, std::vector<std::pair<double, Pose>>& poses) const {
  auto known = std::find_if(poses.begin(), poses.end(), [&](const auto& one) { return one.first == time_s; });
  if (known != poses.end()) return known->second;
  poses.emplace_back(time_s, poser_.at(time_s, view_.raster_s));
  return poses.back().second;
}

Pose FramePoser::at(double time_s) const {
  std::vector<std::pair<double, Pose>> poses;  // by time
  const double camera_s = cameraTime(time_s);
  Pose pose = poser_.at(camera_s, view_.raster_s);
  for (size_t i = 0; i < instances_.size(); ++i) {
    const double own_s = instanceTime(i, time_s);
    if (own_s == camera_s) continue;
    const Pose& own = posed(own_s, poses);
    pose.world_from_instance[i] = own.world_from_instance[i];
    pose.bends[i] = own.bends[i];
  }
  for (size_t i = 0; i < lights_.size(); ++i) {
    const double own_s = lightTime(i, time_s);
    if (own_s == camera_s) continue;
    const Pose& own = posed(own_s, poses);
    pose.world_from_light[i] = own.world_from_light[i];
    pose.lights[i] = own.lights[i];
  }
  return pose;
}

}  // namespace strobe::scene
