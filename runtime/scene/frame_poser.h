// SPDX-License-Identifier: MIT
// The poses of one frame: the scene at its times, without what must not blur. What jumps (STEP channels, cuts) stands
// as it does at the raster time; of the motion of the camera and of objects a share is kept. Whoever draws the frame
// has these poses, truth and filters alike.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

struct FrameTimes {
  double capture_s = 0, open_s = 0, close_s = 0;
  // Shares of the motion that are kept, 0 (none) to 1: at a time t things are where they truly are at capture + share *
  // (t - capture).
  double camera_share = 1, object_share = 1;
  int followed = -1;              // a node that keeps the camera's share instead, with all below it; -1: none
  std::vector<double> cuts = {};  // seconds at which everything jumps, beside the scene's own
};

class FramePoser {
 public:
  // `scene` must outlive it. Throws as `Poser` does.
  FramePoser(const Scene& scene, int camera_node, const std::string& animation, const FrameTimes& times);

  Pose at(double time_s) const;
  // The times at which the camera, an instance and a light (of instancesOf and lightsOf) are where `at(time_s)` has
  // them.
  double cameraTime(double time_s) const { return timeOf(camera_, time_s); }
  double instanceTime(size_t instance, double time_s) const { return timeOf(instances_[instance], time_s); }
  double lightTime(size_t light, double time_s) const { return timeOf(lights_[light], time_s); }

 private:
  // Whose time a node follows.
  enum class Clock { Objects, Camera };
  struct NodeTime {
    Clock clock = Clock::Objects;
    std::vector<double> cuts;             // of the node and all above it, the scene's and the frame's
    std::vector<const Animation*> clips;  // with cuts, that drive the node or one above it
    void add(const NodeTime& other);
  };

  void addClips(const Scene& scene, const std::string& animation, std::vector<NodeTime>& nodes) const;
  NodeTime ofInstance(const Scene& scene, const Instance& instance, const std::vector<NodeTime>& nodes) const;
  bool isCut(const NodeTime& node, double from_s, double to_s) const;
  double timeOf(const NodeTime& node, double time_s) const;
  const Pose& posed(double time_s, std::vector<std::pair<double, Pose>>& poses) const;

  Poser poser_;
  FrameTimes times_;
  std::vector<NodeTime> instances_, lights_;
  NodeTime camera_;
};

}  // namespace strobe::scene
