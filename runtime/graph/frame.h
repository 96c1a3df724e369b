// SPDX-License-Identifier: MIT
// What a frame is drawn from besides plan and scene, and what it gives.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "image/image.h"
#include "math/shutter_curve.h"
#include "plan/plan.h"
#include "scene/screen_motion.h"
#include "world/gpu_scene.h"

namespace strobe::graph {

// When and how a frame sees its scene; everything an image depends on besides plan and scene.
struct FrameSetup {
  std::function<scene::Pose(double time_s)> pose_at;
  double capture_s = 0;            // scene time of the capture
  double open_s = 0, close_s = 0;  // the exposure window
  ShutterCurve curve;              // how much its times count
  double frame_s = 0;              // time from frame to frame
  uint32_t anchor = 0;             // ANCHOR_* of shaders/shared/frame.h
  uint32_t frame = 0;
  uint32_t seed = 0;
  vec2 subpixel = vec2(0);  // sample position relative to the pixel's centre, px
  scene::Environment environment;
  scene::PixelArea reach;                                       // where anything that moves can be seen
  std::function<scene::PixelArea(const scene::Pose&)> area_at;  // the same at one pose; none: not known
  std::vector<bool> moves;                        // by instance: may it move within the exposure? Empty: each may
  std::vector<scene::ScreenPath> paths;           // by instance; empty: not known
  bool camera_rests = false;                      // within the exposure
  const std::set<std::string>* wanted = nullptr;  // outputs and taps to read back; null: all
};

// What was read back of one image: floats, or unsigned integers.
struct ReadImage {
  std::string format;
  image::Image floats;
  image::UintImage uints;
};

struct StepTime {
  std::string name;   // node
  double gpu_ms = 0;  // summed over the iterations of its loop
  int executions = 0;
};

struct FrameResult {
  std::map<std::string, ReadImage> outputs;                // by name of the output
  std::map<std::string, ReadImage> taps;                   // by "node.port"
  std::vector<std::pair<std::string, uint64_t>> counters;  // "node.counter", in the order of execution
  std::vector<std::pair<std::string, int>> iterations;     // of each loop, fewer than planned if it stopped early
  std::vector<StepTime> times;
  double gpu_ms = 0;  // spans of the submissions, summed
};

// The frame's block for a plan, as it is outside of loops.
shared::FrameData frameData(const plan::Plan& plan, const world::GpuScene& scene, const FrameSetup& setup);

// A part of the exposure as a frame of its own, for a loop that draws parts; the iteration counts from `loop.first`.
// Parts have equal shares of the curve's weight, and even weight within. The raster time is the middle of the
// part. Every instance counts as moving, and every pixel as reached.
FrameSetup partSetup(const FrameSetup& setup, const plan::Plan& plan, const plan::PlanLoop& loop, int iteration);

// Poses what every frame sees: the capture, the ends of the exposure, the frame before.
void poseFixedSlices(world::GpuScene& scene, gpu::Staging& staging, const plan::Plan& plan, const FrameSetup& setup);
// Which of the parts of the exposure an iteration samples, which counts from `loop.first`. A loop that may stop early,
// or takes some of them, does so by steps of the golden ratio: however many were taken, they lie all over the exposure.
int partOf(const plan::PlanLoop& loop, int iteration);
// Poses the sample slices of an iteration, which counts from `loop.first`: midpoints of strata, or a random time in
// each of their parts. Strata have equal shares of the shutter curve's weight, in loops of even times of the exposure.
// In a loop of frames a slice is a frame before the last one, and the first of the first part one before the capture.
void poseSamples(world::GpuScene& scene, gpu::Staging& staging, const plan::Plan& plan, const FrameSetup& setup,
                 const plan::PlanLoop& loop, int iteration);

}  // namespace strobe::graph
