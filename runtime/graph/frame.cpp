// SPDX-License-Identifier: MIT
#include "graph/frame.h"

#include <cmath>
#include <numeric>

#include "math/sampling.h"

namespace strobe::graph {

using plan::Plan;

// Copies the shutter curve to the shader constants.
static void setCurve(const ShutterCurve& curve, shared::FrameData& frame) {
  static_assert(ShutterCurve::kMostKnots <= CURVE_KNOTS);
  vec4* const halves[] = {frame.curve_opening, frame.curve_closing};
  for (int end : {0, 1}) {
    const std::vector<ShutterCurve::Knot>& knots = curve.knotsFrom(end);
    for (size_t i = 0; i < knots.size(); ++i)
      halves[end][i] = vec4(knots[i].distance, knots[i].share, knots[i].weight, knots[i].slope);
    frame.curve_counts[end] = uint32_t(knots.size());
    double at_capture = end == 0 ? -frame.shutter.x : frame.shutter.y;  // distance from this end
    frame.curve_sides[end] = float(end == 0 ? curve.shareBefore(at_capture) : 1 - curve.shareBefore(1 - at_capture));
  }
}

static ivec4 vectorOf(const scene::PixelArea& area) { return ivec4(area.x0, area.y0, area.x1, area.y1); }

shared::FrameData frameData(const Plan& plan, const world::GpuScene& scene, const Frame& setup) {
  shared::FrameData frame{};
  frame.size = uvec2(plan.width, plan.height);
  frame.subpixel = setup.subpixel;
  frame.shutter = setup.anchor == ANCHOR_END     ? vec2(-1, 0)
                  : setup.anchor == ANCHOR_START ? vec2(0, 1)
                                                 : vec2(-0.5f, 0.5f);
  frame.anchor = setup.anchor;
  frame.frame = setup.frame;
  frame.seed = setup.seed;
  frame.iteration_count = frame.slice_count = 1;
  frame.instance_count = scene.instanceCount();
  frame.light_count = scene.lightCount();
  frame.sky = setup.environment.sky;
  frame.ground = setup.environment.ground;
  frame.moving_rect = vectorOf(setup.motion.moving_rect);
  frame.camera_rests = setup.facts.camera_moves ? 0 : 1;
  frame.moving_count = scene.movingCount();
  frame.exposure = float((setup.view.close_s - setup.view.open_s) / setup.frame_s);
  setCurve(setup.curve, frame);
  if (setup.environment.background) frame.background = vec4(*setup.environment.background, 1);
  return frame;
}

// One origin for every pose of the frame: the camera at the raster time.
static dvec3 frameOrigin(const Frame& setup) { return dvec3(setup.pose_at(setup.view.raster_s).world_from_camera[3]); }

static void setPose(world::GpuScene& scene, gpu::Staging& staging, uint32_t slice, const Plan& plan, const Frame& setup,
                    double time_s, const dvec3& origin) {
  const scene::Pose pose = setup.pose_at(time_s);
  const ivec4 moving = vectorOf(setup.motion.area_at ? setup.motion.area_at(pose) : setup.motion.moving_rect);
  scene.setPose(staging, slice, pose, double(plan.width) / plan.height, origin, moving);
}

void poseFixedSlices(world::GpuScene& scene, gpu::Staging& staging, const Plan& plan, const Frame& setup) {
  dvec3 origin = frameOrigin(setup);
  scene.setMotion(staging, setup.facts.moves, setup.motion.paths);
  const double times[] = {setup.view.raster_s, setup.view.open_s, setup.view.close_s,
                          setup.view.raster_s - setup.frame_s};
  for (uint32_t slice : {SLICE_RASTER, SLICE_SHUTTER_OPEN, SLICE_SHUTTER_CLOSE, SLICE_PREVIOUS})
    setPose(scene, staging, slice, plan, setup, times[slice], origin);
}

int partOf(const plan::PlanLoop& loop, int iteration) {
  if (loop.until < 0 && loop.parts == loop.count) return iteration;
  int64_t stride = std::max<int64_t>(std::llround(loop.parts * 0.6180339887498949), 1);
  while (std::gcd(stride, int64_t(loop.parts)) != 1) ++stride;
  return int(iteration * stride % loop.parts);
}

Frame partSetup(const Frame& setup, const Plan& plan, const plan::PlanLoop& loop, int iteration) {
  const int part = partOf(loop, iteration);
  auto endOf = [&](int parts) {
    return glm::mix(setup.view.open_s, setup.view.close_s, setup.curve.timeOf(double(parts) / loop.parts));
  };
  Frame frame = setup;
  frame.view.open_s = endOf(part), frame.view.close_s = endOf(part + 1);
  frame.view.raster_s = 0.5 * (frame.view.open_s + frame.view.close_s);
  frame.curve = {};
  frame.anchor = ANCHOR_CENTRE;
  frame.motion = {{0, 0, plan.width, plan.height}, {}, {}};
  frame.facts = {};
  return frame;
}

// Time of slice `q` of a part, seconds.
static double sampleTime(const Frame& setup, const plan::PlanLoop& loop, int part, int q) {
  if (loop.times == "frames") return setup.view.raster_s - (double(part) * loop.slices + q + 1) * setup.frame_s;
  // Midpoints of the stratum's equal parts, or one random time in each. Loops differ in their random times.
  double in_stratum = (q + 0.5) / loop.slices;
  if (loop.times == "stratified") {
    uint32_t index = uint32_t(part) * uint32_t(loop.slices) + uint32_t(q);
    in_stratum = (q + hashUniform(setup.seed, setup.frame, index, uint32_t(loop.loop))) / loop.slices;
  }
  double share = (part + in_stratum) / loop.parts;
  if (loop.times != "even") share = setup.curve.timeOf(share);
  return setup.view.open_s + (setup.view.close_s - setup.view.open_s) * share;
}

void poseSamples(world::GpuScene& scene, gpu::Staging& staging, const Plan& plan, const Frame& setup,
                 const plan::PlanLoop& loop, int iteration) {
  dvec3 origin = frameOrigin(setup);
  int part = partOf(loop, iteration);
  for (int q = 0; q < loop.slices; ++q)
    setPose(scene, staging, SLICE_SAMPLE + uint32_t(q), plan, setup, sampleTime(setup, loop, part, q), origin);
}

}  // namespace strobe::graph
