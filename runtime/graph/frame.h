// SPDX-License-Identifier: MIT
// Inputs of a frame besides plan and scene, and its results.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "image/image.h"
#include "math/shutter_curve.h"
#include "plan/plan.h"
#include "scene/facts.h"
#include "scene/frame_poser.h"
#include "scene/screen_motion.h"
#include "world/gpu_scene.h"

namespace strobe::graph {

// Times, camera poses and random seed of a frame: all inputs of an image besides plan and scene.
struct Frame {
  std::function<scene::Pose(double time_s)> pose_at;
  scene::FrameView view;  // times and size of the picture
  ShutterCurve curve;     // weight of each time of the exposure
  double frame_s = 0;     // time between two frames
  uint32_t anchor = 0;    // ANCHOR_* of shaders/shared/frame.h
  uint32_t frame = 0;
  uint32_t seed = 0;
  vec2 subpixel = vec2(0);  // sample position relative to the pixel's centre, px
  scene::Environment environment;
  scene::ScreenMotion motion;                     // in the picture; `paths` empty: unknown
  scene::Facts facts;                             // of the scene; the initial value assumes everything
  bool model_everything = false;                  // also run passes that the facts do not require
  const std::set<std::string>* wanted = nullptr;  // outputs and taps to read back; null: all
};

// Pixels of one image that was read back: floats or unsigned integers.
struct ReadImage {
  std::string format;
  image::Image floats;
  image::UintImage uints;

  bool isUint() const { return !uints.values.empty(); }
  int width() const { return isUint() ? uints.width : floats.width; }
  int height() const { return isUint() ? uints.height : floats.height; }
  int channels() const { return isUint() ? uints.channels : floats.channels; }
};

// GPU time of one node in a frame, milliseconds, and the number of its executions.
struct StepTime {
  std::string name;   // node
  double gpu_ms = 0;  // summed over the iterations of its loop
  int executions = 0;
};

// Results of a drawn frame: images that were read back, event counters, loop iterations and GPU times in milliseconds.
struct FrameResult {
  std::map<std::string, ReadImage> outputs;                // by output name
  std::map<std::string, ReadImage> taps;                   // by "node.port"
  std::vector<std::pair<std::string, uint64_t>> counters;  // "node.counter", in execution order
  std::vector<std::pair<std::string, int>> iterations;     // by loop; fewer than planned if the loop stopped early
  std::vector<StepTime> times;
  double gpu_ms = 0;  // sum over the submissions
};

// Returns the shader constants of a frame, outside of loops.
shared::FrameData frameData(const plan::Plan& plan, const world::GpuScene& scene, const Frame& setup);

// Returns a part of the exposure as a frame, for a loop over parts; `iteration` counts from `loop.first`. Parts have
// equal shares of the shutter curve's weight; the weight within a part is constant. The raster time is the middle of
// the part. All instances count as moving, and the moving rectangle is the image.
Frame partSetup(const Frame& setup, const plan::Plan& plan, const plan::PlanLoop& loop, int iteration);

// Poses the slices of every frame: raster time, shutter open, shutter close, previous frame.
void poseFixedSlices(world::GpuScene& scene, gpu::Staging& staging, const plan::Plan& plan, const Frame& setup);
// Returns the part of the exposure of an iteration, which counts from `loop.first`. A loop that may stop early, or that
// samples only some parts, steps by the golden ratio: the parts done so far are spread over the whole exposure.
int partOf(const plan::PlanLoop& loop, int iteration);
// Poses the sample slices of an iteration, which counts from `loop.first`. Sample times are midpoints of the stratum's
// equal parts, or one random time in each. Strata have equal shares of the shutter curve's weight; with `times` "even",
// equal durations. With `times` "frames", slice q of part p is (p * slices + q + 1) frames before the raster time.
void poseSamples(world::GpuScene& scene, gpu::Staging& staging, const plan::Plan& plan, const Frame& setup,
                 const plan::PlanLoop& loop, int iteration);

}  // namespace strobe::graph
