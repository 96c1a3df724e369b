// SPDX-License-Identifier: MIT
#include "lab/frame_facts.h"

#include <algorithm>

#include "lab/drawing.h"
#include "math/shutter_curve.h"
#include "plan/facts.h"
#include "scene/motion.h"

namespace strobe::lab {

// True if the camera of `view` or `path` moves; empty if the shot uses the scene's camera.
static std::optional<bool> movesOfItself(const Shot& shot) {
  if (shot.view) return false;
  if (shot.path.empty()) return std::nullopt;
  return shot.path.size() > 1;
}

scene::FrameTimes frameTimesOf(const Shot& shot, const scene::Scene& scene) {
  scene::FrameTimes times{shot.captureTime(), shot.window()[0], shot.window()[1], shot.camera_blur, shot.object_blur};
  times.cuts = scene::cutsFromOption(shot.cuts);
  if (!shot.follow.empty()) times.followed = scene::nodeByName(scene, shot.follow);
  return times;
}

double previousTime(const Shot& shot, int earlier_frames) {
  const bool looks = earlier_frames > 0 || shot.window()[0] < shot.window()[1];
  return looks ? shot.captureTime() - 1 / shot.fps : shot.captureTime();
}

scene::Facts factsOf(const Shot& shot, const scene::Scene& scene, int earlier_frames) {
  scene::FrameView view;
  view.camera_node = scene::cameraNode(scene, shot.camera);
  view.animation = shot.animation;
  view.times = frameTimesOf(shot, scene);
  view.previous_s = previousTime(shot, earlier_frames);
  view.camera_moves = movesOfItself(shot);
  return scene::factsOf(scene, view);
}

// True for facts about motion. A part of the exposure has its own raster time and previous frame, so no fact about its
// motion is proven.
static bool isOfMotion(const std::string& name) {
  const plan::Fact* fact = plan::findFact(name);
  return !fact->compiled_in && !fact->compiled_into_all;
}

std::vector<std::string> absentFacts(const Shot& shot, const scene::Scene& scene, const plan::PipelineDesc& pipeline) {
  if (shot.model_everything) return {};
  const int earlier_frames = plan::earlierFrames(pipeline);
  const scene::Facts facts = factsOf(shot, scene, earlier_frames);
  const std::vector<scene::ScreenPath> paths = frameSetup(shot, scene, earlier_frames).paths;
  std::vector<std::string> absent;
  if (!facts.motion) absent.push_back("motion");
  if (std::none_of(paths.begin(), paths.end(), [](const scene::ScreenPath& path) { return path.curved; }))
    absent.push_back("curves");
  if (!facts.alpha) absent.push_back("alpha");
  if (!facts.blend) absent.push_back("blend");
  if (!facts.one_sided) absent.push_back("one_sided");
  if (!facts.shadows) absent.push_back("shadows");
  if (!facts.deforms) absent.push_back("deforms");
  if (!(shot.window()[0] < shot.captureTime())) absent.push_back("before");
  if (!(shot.window()[1] > shot.captureTime())) absent.push_back("after");
  if (ShutterCurve::from(shot.shutter_curve).isBox()) absent.push_back("weighted");
  if (plan::hasParts(pipeline) && shot.window()[0] < shot.window()[1]) std::erase_if(absent, isOfMotion);
  return absent;
}

}  // namespace strobe::lab
