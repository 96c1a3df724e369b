// SPDX-License-Identifier: MIT
// Poses of one frame, without motion that must not blur. Jumps (STEP channels, cuts) keep the state of the raster time.
// The motion of the camera and of objects is reduced to a share. Ground truth and filters draw the same poses.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// Times of a frame, the motion that it keeps, and the size of its picture.
struct FrameView {
  double raster_s = 0, open_s = 0, close_s = 0;
  double previous_s = 0;               // raster time of the previous frame
  std::vector<double> earlier_s = {};  // raster times of frames before the previous frame, if the pipeline uses them
  int width = 0, height = 0;           // of the picture, px
  // Shares of the motion that are kept, 0 (none) to 1: at time t, an object has its true pose of the time capture +
  // share * (t - capture).
  double camera_share = 1, object_share = 1;
  int followed = -1;              // node that, with its descendants, has the camera's share; -1: no node
  std::vector<double> cuts = {};  // times, s, of jumps of all objects, besides the scene's cuts
};

// Poses of a scene at any time of one frame, with jumps held at the raster time and the motion of camera and objects
// scaled by their shares.
class FramePoser {
 public:
  // `scene` must outlive the poser. Throws as `Poser` does.
  FramePoser(const Scene& scene, int camera_node, const std::string& animation, const FrameView& view);

  const Scene& scene() const { return scene_; }
  int cameraNode() const { return camera_node_; }
  const std::string& animation() const { return animation_; }
  const FrameView& view() const { return view_; }

  Pose at(double time_s) const;
  // Times of the true poses that `at(time_s)` has for the camera, for an instance (index into instancesOf) and for a
  // light (index into lightsOf).
  double cameraTime(double time_s) const { return timeOf(camera_, time_s); }
  double instanceTime(size_t instance, double time_s) const { return timeOf(instances_[instance], time_s); }
  double lightTime(size_t light, double time_s) const { return timeOf(lights_[light], time_s); }

 private:
  // Share of the motion that a node follows.
  enum class Clock { Objects, Camera };
  struct NodeTime {
    Clock clock = Clock::Objects;
    std::vector<double> cuts;             // of the node and its ancestors, the scene and the frame
    std::vector<const Animation*> clips;  // clips with cuts that drive the node or an ancestor
    void add(const NodeTime& other);
  };

  void addClips(std::vector<NodeTime>& nodes) const;
  NodeTime ofInstance(const Instance& instance, const std::vector<NodeTime>& nodes) const;
  bool isCut(const NodeTime& node, double from_s, double to_s) const;
  double timeOf(const NodeTime& node, double time_s) const;
  const Pose& posed(double time_s, std::vector<std::pair<double, Pose>>& poses) const;

  const Scene& scene_;
  int camera_node_;
  std::string animation_;
  Poser poser_;
  FrameView view_;
  std::vector<NodeTime> instances_, lights_;
  NodeTime camera_;
};

}  // namespace strobe::scene
