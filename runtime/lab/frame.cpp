// SPDX-License-Identifier: MIT
#include "lab/frame.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lab/camera_path.h"
#include "math/shutter_curve.h"
#include "plan/facts.h"
#include "scene/depth_bounds.h"
#include "scene/motion.h"
#include "shader/interface.h"

namespace strobe::lab {

// Camera at the first point, looking at the second; y is up, or z if the view is along y.
static dmat4 worldFromView(const std::array<double, 6>& view) {
  dvec3 eye(view[0], view[1], view[2]), target(view[3], view[4], view[5]);
  dvec3 back = glm::normalize(eye - target);
  dvec3 up = std::abs(back.y) > 0.9999 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  dvec3 right = glm::normalize(glm::cross(up, back));
  return dmat4(dvec4(right, 0), dvec4(glm::cross(back, right), 0), dvec4(back, 0), dvec4(eye, 1));
}

// Area widened to whole workgroups. In full-size passes each pixel then has the same neighbours in its workgroup,
// wherever the area lies. On some devices the last bit of a filtered texture depends on these neighbours.
static scene::PixelArea inWholeGroups(const scene::PixelArea& area, int width, int height) {
  if (area.empty()) return area;
  const int group = int(shader::kGroupSize);
  const auto up = [&](int x) { return (x + group - 1) / group * group; };
  return {area.x0 / group * group, area.y0 / group * group, std::min(up(area.x1), width),
          std::min(up(area.y1), height)};
}

// The previous time equals the raster time if the exposure has no length and the pipeline uses no earlier frames,
// because extrapolated displacements then have no length.
static scene::FrameView viewOf(const Shot& shot, const scene::Scene& scene, int earlier_frames) {
  scene::FrameView view;
  view.raster_s = shot.rasterTime();
  view.open_s = shot.window()[0], view.close_s = shot.window()[1];
  const bool uses_previous = earlier_frames > 0 || view.open_s < view.close_s;
  view.previous_s = uses_previous ? view.raster_s - 1 / shot.fps : view.raster_s;
  for (int k = 2; k <= earlier_frames; ++k) view.earlier_s.push_back(view.raster_s - k * (1 / shot.fps));
  view.width = shot.width, view.height = shot.height;
  view.camera_share = shot.camera_blur, view.object_share = shot.object_blur;
  view.cuts = scene::cutsFromOption(shot.cuts);
  if (!shot.follow.empty()) view.followed = scene::nodeByName(scene, shot.follow);
  return view;
}

// True if the camera of `view` or `path` moves; empty if the shot uses the scene's camera.
static std::optional<bool> movesOfItself(const Shot& shot) {
  if (shot.view) return false;
  if (shot.path.empty()) return std::nullopt;
  return shot.path.size() > 1;
}

graph::Frame frameOf(const Shot& shot, const scene::Scene& scene, int earlier_frames) {
  auto poser = std::make_shared<scene::FramePoser>(scene, scene::cameraNode(scene, shot.camera), shot.animation,
                                                   viewOf(shot, scene, earlier_frames));
  const scene::FrameView& view = poser->view();
  graph::Frame frame;
  frame.pose_at = [poser, view = shot.view, keys = cameraKeys(shot.path), fps = shot.fps](double time_s) {
    scene::Pose pose = poser->at(time_s);
    if (view) pose.world_from_camera = worldFromView(*view);
    else if (!keys.empty()) pose.world_from_camera = worldFromView(viewAt(keys, poser->cameraTime(time_s) * fps));
    return pose;
  };
  std::vector<double> shares;  // share of its motion that each instance keeps; empty: all keep their whole motion
  if (!shot.motion_depths.empty()) {
    shares = scene::motionShares(scene, frame.pose_at(view.raster_s), scene::DepthBounds::from(shot.motion_depths));
    frame.pose_at = [true_pose = frame.pose_at, shares, raster_s = view.raster_s](double time_s) {
      return scene::boundedPose(true_pose, shares, raster_s, time_s);
    };
  }
  frame.view = view;
  frame.curve = ShutterCurve::from(shot.shutter_curve);
  frame.frame_s = 1 / shot.fps;
  frame.anchor = anchorCode(shot.anchor);
  frame.frame = uint32_t(shot.frame);
  frame.seed = shot.seed;
  frame.environment = scene.environment;
  frame.motion = scene::screenMotionOf(scene, frame.pose_at, view);
  frame.motion.moving_rect = inWholeGroups(frame.motion.moving_rect, shot.width, shot.height);
  frame.model_everything = shot.model_everything;
  if (shot.model_everything) {
    frame.motion.moving_rect = {0, 0, shot.width, shot.height};
    return frame;
  }
  frame.facts = scene::factsOf(*poser, movesOfItself(shot));
  // An instance that keeps less than its whole motion follows the camera.
  std::vector<bool>& moves = frame.facts.moves;
  for (size_t i = 0; i < shares.size() && i < moves.size(); ++i)
    if (shares[i] < 1) moves[i] = frame.facts.camera_moves || (moves[i] && shares[i] > 0);
  return frame;
}

// True for facts about motion. A part of the exposure has its own raster time and previous frame, so no fact about its
// motion is proven.
static bool isOfMotion(const std::string& name) {
  const plan::Fact* fact = plan::findFact(name);
  return !fact->compiled_in && !fact->compiled_into_all;
}

std::vector<std::string> absentFacts(const graph::Frame& frame, const plan::PipelineDesc& pipeline) {
  if (frame.model_everything) return {};
  const scene::Facts& facts = frame.facts;
  const std::vector<scene::ScreenPath>& paths = frame.motion.paths;
  std::vector<std::string> absent;
  if (!facts.motion) absent.push_back("motion");
  if (std::none_of(paths.begin(), paths.end(), [](const scene::ScreenPath& path) { return path.curved; }))
    absent.push_back("curves");
  if (!facts.alpha) absent.push_back("alpha");
  if (!facts.blend) absent.push_back("blend");
  if (!facts.one_sided) absent.push_back("one_sided");
  if (!facts.shadows) absent.push_back("shadows");
  if (!facts.deforms) absent.push_back("deforms");
  if (!(frame.view.open_s < frame.view.raster_s)) absent.push_back("before");
  if (!(frame.view.close_s > frame.view.raster_s)) absent.push_back("after");
  if (frame.curve.isBox()) absent.push_back("weighted");
  if (plan::hasParts(pipeline) && frame.view.open_s < frame.view.close_s) std::erase_if(absent, isOfMotion);
  return absent;
}

}  // namespace strobe::lab
