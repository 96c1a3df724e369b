// SPDX-License-Identifier: MIT
#include "graph/graph.h"

#include <algorithm>

#include "base/log.h"

namespace strobe::graph {

using plan::Plan;
using plan::Step;

constexpr uint32_t kUsualSlices = 32;

uint32_t Graph::sampleSlices(const Plan& plan) {
  uint32_t slices = 0;
  for (const auto& loop : plan.loops) slices = std::max(slices, uint32_t(loop.slices));
  // Shaders are compiled for a number of slices. More than one is rounded up to the usual number, so that plans share
  // shaders.
  return slices <= 1 ? slices : std::max(slices, kUsualSlices);
}

static bool traces(const Plan& plan, const plan::PlanNode& node) {
  return plan.passOf(node).kind == plan::PassDesc::Kind::Trace;
}

static bool traces(const Plan& plan) {
  return std::any_of(plan.nodes.begin(), plan.nodes.end(), [&](const auto& node) { return traces(plan, node); });
}

static bool traces(const Plan& plan, const std::vector<Step>& steps) {
  return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
    return step.kind == Step::Kind::Pass && traces(plan, plan.nodes[size_t(step.index)]);
  });
}

// Time samples of a loop. An iteration without sample times counts as one.
static int samplesOf(const plan::PlanLoop& loop, int iterations) { return iterations * std::max(loop.slices, 1); }

static int samplesOf(const Plan& plan) {
  int samples = 0;
  for (const plan::PlanLoop& loop : plan.loops) samples += samplesOf(loop, loop.count);
  return samples;
}

// Returns the nodes with their pipelines; `ms` receives the time to find and compile them.
static PlanNodes nodesOf(const gpu::Device& device, const Plan& plan, PipelineCache& cache,
                         const world::GpuScene& scene, Backend backend, const PlanNodes* previous,
                         std::vector<std::string>* problems, double& ms) {
  STROBE_ASSERT(scene.slices() >= SLICE_SAMPLE + Graph::sampleSlices(plan), "{} slices", scene.slices());
  double started_s = clockSeconds();
  PlanNodes nodes(device, plan);
  nodes.findPipelines(cache, scene, backend, previous, problems);
  ms = 1000 * (clockSeconds() - started_s);
  return nodes;
}

// True if the host waits for each iteration: for loops that may stop early, and for long loops, which report progress
// and would fill the staging memory.
static bool waitsForLoops(const Plan& plan) {
  constexpr int kShort = 4;
  return std::any_of(plan.loops.begin(), plan.loops.end(),
                     [](const plan::PlanLoop& loop) { return loop.until >= 0 || loop.count > kShort; });
}

ImageBytes Graph::bytes(const Plan& plan, size_t in_flight) {
  return imageBytes(plan, waitsForLoops(plan) ? 1 : in_flight);
}

Graph::Graph(const gpu::Device& device, PipelineCache& cache, const Plan& plan, world::GpuScene& scene, Backend backend,
             size_t in_flight, Graph* previous, std::vector<std::string>* problems)
    : plan_(&plan),
      scene_(scene),
      waits_(waitsForLoops(plan)),
      in_flight_(waits_ ? 1 : in_flight),
      traces_(traces(plan)),
      nodes_(
          nodesOf(device, plan, cache, scene, backend, previous ? &previous->nodes_ : nullptr, problems, compile_ms_)),
      clears_(device),
      recording_(device, scene, images_, nodes_, clears_),
      submission_(device, scene, recording_, nodes_, in_flight_),
      images_(device, plan, in_flight_, previous ? &previous->images_ : nullptr) {
  STROBE_ASSERT(!previous || previous->underWay() == 0);
  try {
    nodes_.make(images_, in_flight_);
    // For a stepwise software device, Vulkan's own clears are as fast.
    if (!submission_.isStepwise()) clears_.make(cache, plan, images_);
  } catch (...) {
    if (previous) images_.giveBack(previous->images_);
    throw;
  }
}

std::map<std::string, std::shared_ptr<const NodePipeline>> Graph::pipelines() const {
  std::map<std::string, std::shared_ptr<const NodePipeline>> pipelines;
  for (size_t i = 0; i < nodes_.size(); ++i) pipelines[nodes_.name(i)] = nodes_[i].pipeline;
  return pipelines;
}

void Graph::setParams(const Plan& plan) {
  plan_ = &plan;
  images_.setPlan(plan);
  nodes_.setPlan(plan);
}

Graph::~Graph() {
  try {
    drop();
  } catch (const std::exception&) {
    // The device is lost; the next call on the device reports that.
  }
}

FrameResult Graph::run(const Frame& setup, const OnIteration& on_iteration) {
  drop();
  begin(setup, on_iteration);
  return finish();
}

void Graph::drop() {
  while (!under_way_.empty()) takeFirst();
}

// Removes the oldest frame in flight after the device has executed it.
Graph::UnderWay Graph::takeFirst() {
  UnderWay frame = std::move(under_way_.front());
  under_way_.pop_front();
  submission_.wait(frame.index);
  return frame;
}

void Graph::begin(const Frame& setup, const OnIteration& on_iteration) {
  STROBE_ASSERT(underWay() < mostUnderWay(), "{} frames are under way", underWay());
  UnderWay frame{next_};
  if (setup.wanted) frame.wanted = *setup.wanted;
  ++runs_;
  try {
    draw(setup, frame, on_iteration);
  } catch (...) {
    // The scene has marked staged data as written.
    submission_.submit(frame.index, {});
    submission_.wait(frame.index);
    throw;
  }
  images_.frameIsRecorded();
  next_ = (next_ + 1) % in_flight_;
  under_way_.push_back(std::move(frame));
}

// Poses the scene for a frame or a part of its exposure, and returns the frame's shader constants.
shared::FrameData Graph::posed(const Frame& setup, const UnderWay& frame) {
  poseFixedSlices(scene_, submission_.staging(frame.index), *plan_, setup);
  return frameData(*plan_, scene_, setup);
}

void Graph::draw(const Frame& setup, UnderWay& frame, const OnIteration& on_iteration) {
  gpu::Staging& staging = submission_.staging(frame.index);
  recording_.setFrame(*plan_, frame.index, setup);
  nodes_.begin(frame.index);
  submission_.begin(frame.index);
  shared::FrameData data = posed(setup, frame);
  scene_.setFrame(staging, data);
  frame.samples = samplesOf(*plan_);

  // Steps between loops are one submission. Each iteration of a loop is a separate submission, because it needs the
  // scene in a new pose.
  Submission::Part part;
  part.slice_count = traces_ ? 1 : 0;
  for (const Step& step : plan_->steps) {
    if (step.kind != Step::Kind::Loop) {
      part.steps.push_back(&step);
      continue;
    }
    submission_.submit(frame.index, part);
    if (waits_) submission_.wait(frame.index);
    part = {};
    runLoop(setup, step, data, frame, on_iteration);
    if (plan_->loops[size_t(step.index)].drawsParts()) {
      data = posed(setup, frame);
      part.slice_count = traces_ ? 1 : 0;
    }
    scene_.setFrame(staging, data);
  }
  submission_.submit(frame.index, part);
}

void Graph::runLoop(const Frame& setup, const Step& step, shared::FrameData data, UnderWay& frame,
                    const OnIteration& on_iteration) {
  const plan::PlanLoop& loop = plan_->loops[size_t(step.index)];
  gpu::Staging& staging = submission_.staging(frame.index);
  Submission::Part part;
  for (const Step& inner : step.body) part.steps.push_back(&inner);
  part.first_slice = loop.drawsParts() ? SLICE_RASTER : SLICE_SAMPLE;
  part.slice_count = traces(*plan_, step.body) ? uint32_t(loop.slices) : 0;
  int iteration = 0;
  bool stop = false;
  while (iteration < loop.count && !stop) {
    const int number = loop.first + iteration;
    if (loop.drawsParts()) data = posed(partSetup(setup, *plan_, loop, number), frame);
    else poseSamples(scene_, staging, *plan_, setup, loop, number);
    data.iteration_count = uint32_t(loop.parts);
    data.slice_count = uint32_t(loop.slices);
    data.iteration = uint32_t(number);
    data.part = uint32_t(partOf(loop, number));
    scene_.setFrame(staging, data);
    part.iteration = iteration;
    submission_.submit(frame.index, part);
    if (waits_) submission_.wait(frame.index);
    ++iteration;
    if (loop.until >= 0) stop = static_cast<const float*>(images_.readBack(loop.until, frame.index).mapped())[0] != 0;
    if (on_iteration) on_iteration(frame.samples_done + samplesOf(loop, stop ? loop.count : iteration), frame.samples);
  }
  frame.samples_done += samplesOf(loop, loop.count);
  frame.result.iterations.push_back({plan_->pipeline.loops[size_t(loop.loop)].name, iteration});
}

FrameResult Graph::finish() {
  STROBE_ASSERT(!under_way_.empty(), "no frame is under way");
  UnderWay frame = takeFirst();
  collect(frame);
  return std::move(frame.result);
}

void Graph::collect(UnderWay& frame) const {
  FrameResult& result = frame.result;
  for (const auto& [name, image] : plan_->outputs)
    if (frame.wants(name)) result.outputs[name] = images_.fetch(image, frame.index);
  for (const auto& [name, image] : plan_->taps)
    if (frame.wants(name)) result.taps[name] = images_.fetch(image, frame.index);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const std::string& name = nodes_.name(i);
    const NodeInFrame& node = nodes_[i].frames[frame.index];
    const auto& counters = nodes_[i].pipeline->interface.counters;
    for (size_t c = 0; c < counters.size(); ++c) result.counters.push_back({name + "." + counters[c], node.counts[c]});
    result.times.push_back({name, node.gpu_ms, node.executions});
  }
  result.gpu_ms = submission_.gpuMs(frame.index);
}

}  // namespace strobe::graph
