// SPDX-License-Identifier: MIT
// How a session draws the frame of its shot.
#include <cmath>

#include "base/log.h"
#include "lab/record.h"
#include "lab/session_version.h"
#include "lab/warnings.h"
#include "scene/motion.h"

namespace strobe::lab {

// A camera at rest that looks from one point at another, y up (z where it looks along y).
static dmat4 worldFromView(const std::array<double, 6>& view) {
  dvec3 eye(view[0], view[1], view[2]), target(view[3], view[4], view[5]);
  dvec3 back = glm::normalize(eye - target);
  dvec3 up = std::abs(back.y) > 0.9999 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  dvec3 right = glm::normalize(glm::cross(up, back));
  return dmat4(dvec4(right, 0), dvec4(glm::cross(back, right), 0), dvec4(back, 0), dvec4(eye, 1));
}

graph::FrameSetup frameSetup(const Shot& shot, const scene::Scene& scene) {
  int camera_node = scene::cameraNode(scene, shot.camera);
  auto poser = std::make_shared<scene::Poser>(scene, camera_node, shot.animation);
  graph::FrameSetup setup;
  // Stepped channels stay as they are at the capture: a jump is no motion and must not blur.
  setup.pose_at = [poser, view = shot.view, capture_s = shot.captureTime()](double time_s) {
    scene::Pose pose = poser->at(time_s, capture_s);
    if (view) pose.world_from_camera = worldFromView(*view);
    return pose;
  };
  setup.camera = scene.cameras[size_t(scene.nodes[size_t(camera_node)].camera)];
  setup.capture_s = shot.captureTime();
  setup.open_s = shot.window()[0];
  setup.close_s = shot.window()[1];
  setup.frame_s = 1 / shot.fps;
  setup.anchor = anchorCode(shot.anchor);
  setup.frame = uint32_t(shot.frame);
  setup.seed = shot.seed;
  setup.environment = scene.environment;
  setup.reach = scene::reachOfMotion(scene, setup.camera, setup.pose_at, setup.capture_s, setup.open_s, setup.close_s,
                                     shot.width, shot.height);
  return setup;
}

graph::FrameSetup Session::setup() const { return frameSetup(shot_, scene()); }

graph::FrameResult Session::draw(const std::set<std::string>* wanted, const std::function<void(int, int)>& progress) {
  graph::FrameSetup frame = setup();
  frame.wanted = wanted;
  return running_->graph->run(frame, progress);
}

std::vector<std::string> Session::limitsMet(const graph::FrameResult& frame) const {
  std::vector<std::string> met = lab::limitsMet(shot_, scene());
  for (std::string& one : lab::limitsMet(*running_->plan, frame)) met.push_back(std::move(one));
  return met;
}

// Offset of sub-pixel sample i of n from the pixel's centre: a rank-1 lattice, one sample is the centre.
static vec2 subpixelOffset(int i, int n) {
  if (n == 1) return vec2(0);
  double x = (i + 0.5) / n - 0.5;
  double y = (i + 0.5) * 0.6180339887498949;
  return vec2(x, y - std::floor(y) - 0.5);
}

// The projection a compositing program wants to know: near plane at 0, infinitely far at 1.
static dmat4 ndcFromCamera(const scene::Camera& camera, double aspect) {
  double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
  dmat4 m(0);
  m[0][0] = 1 / (half_height * aspect);
  m[1][1] = 1 / half_height;
  if (camera.orthographic) {
    m[2][2] = -1;
    m[3][2] = -camera.near;
    m[3][3] = 1;
  } else {
    m[2][2] = m[2][3] = -1;
    m[3][2] = -camera.near;
  }
  return m;
}

static void accumulate(graph::FrameResult& sum, const graph::FrameResult& added) {
  auto add = [](std::map<std::string, graph::ReadImage>& into, const std::map<std::string, graph::ReadImage>& from) {
    for (auto& [name, read] : into) {
      const auto& values = from.at(name).floats.values;
      for (size_t i = 0; i < values.size(); ++i) read.floats.values[i] += values[i];
    }
  };
  add(sum.outputs, added.outputs);
  add(sum.taps, added.taps);
  for (size_t i = 0; i < sum.counters.size(); ++i) sum.counters[i].second += added.counters[i].second;
  for (size_t i = 0; i < sum.times.size(); ++i) {
    sum.times[i].gpu_ms += added.times[i].gpu_ms;
    sum.times[i].executions += added.times[i].executions;
  }
  sum.gpu_ms += added.gpu_ms;
}

static void divide(graph::FrameResult& sum, int n) {
  for (auto* images : {&sum.outputs, &sum.taps})
    for (auto& [name, read] : *images)
      for (float& value : read.floats.values) value /= float(n);
}

Picture Session::capture(const std::function<void(int, int)>& progress) {
  double started_s = clockSeconds();
  graph::FrameSetup frame_setup = setup();
  Picture picture;
  double ready_s = clockSeconds();
  for (int i = 0; i < shot_.aa; ++i) {
    frame_setup.subpixel = subpixelOffset(i, shot_.aa);
    auto advance = [&](int done, int of) {
      if (progress) progress(i * of + done, shot_.aa * of);
    };
    running_->graph->forgetHistories();
    graph::FrameResult frame = running_->graph->run(frame_setup, advance);
    if (i == 0) picture.frame = std::move(frame);
    else accumulate(picture.frame, frame);
  }
  if (shot_.aa > 1) divide(picture.frame, shot_.aa);
  double done_s = clockSeconds();

  dmat4 camera_from_world = glm::inverse(frame_setup.pose_at(frame_setup.capture_s).world_from_camera);
  picture.camera_from_world = mat4(camera_from_world);
  double aspect = double(shot_.width) / shot_.height;
  picture.ndc_from_world = mat4(ndcFromCamera(frame_setup.camera, aspect) * camera_from_world);
  std::vector<script::Dependency> dependencies = running_->scripts;
  const auto& of_scene = running_->scene->loaded.dependencies;
  dependencies.insert(dependencies.end(), of_scene.begin(), of_scene.end());
  RecordContext context{shot_,
                        running_->scene->loaded,
                        *running_->plan,
                        running_->plan_hash,
                        bench_.device().info(),
                        running_->backend,
                        dependencies};
  picture.warnings = scene().warnings;
  for (std::string& met : limitsMet(picture.frame)) picture.warnings.push_back(std::move(met));
  picture.record = makeRecord(context, picture.frame);
  picture.record["warnings"] = picture.warnings;
  picture.timings = makeTimings(picture.frame, bench_.device().info(), ready_s - started_s, done_s - ready_s);
  return picture;
}

}  // namespace strobe::lab
