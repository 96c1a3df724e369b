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
  // Shaders are compiled for a number of slices: of several there is room for as many as are usual.
  return slices <= 1 ? slices : std::max(slices, kUsualSlices);
}

static bool traces(const Plan& plan, const plan::PlanNode& node) {
  return plan.pipeline.passes[size_t(node.pass)].kind == plan::PassDesc::Kind::Trace;
}

static bool traces(const Plan& plan) {
  return std::any_of(plan.nodes.begin(), plan.nodes.end(), [&](const auto& node) { return traces(plan, node); });
}

static bool traces(const Plan& plan, const std::vector<Step>& steps) {
  return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
    return step.kind == Step::Kind::Pass && traces(plan, plan.nodes[size_t(step.index)]);
  });
}

// The nodes with their pipelines; `ms` is what finding and compiling them took.
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

Graph::Graph(const gpu::Device& device, PipelineCache& cache, const Plan& plan, world::GpuScene& scene, Backend backend,
             Graph* previous, std::vector<std::string>* problems)
    : plan_(&plan),
      scene_(scene),
      traces_(traces(plan)),
      nodes_(
          nodesOf(device, plan, cache, scene, backend, previous ? &previous->nodes_ : nullptr, problems, compile_ms_)),
      recording_(device, scene, images_, nodes_),
      submission_(device, scene, recording_, nodes_),
      images_(device, plan, previous ? &previous->images_ : nullptr) {
  try {
    nodes_.make(images_);
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

FrameResult Graph::run(const FrameSetup& setup, const std::function<void(int, int)>& on_iteration) {
  FrameResult result;
  ++runs_;
  recording_.setFrame(*plan_, setup);
  submission_.beginFrame();
  poseFixedSlices(scene_, *plan_, setup);
  shared::FrameData frame = frameData(*plan_, scene_, setup);
  scene_.setFrame(frame);

  // Steps between loops go to the device together; each iteration of a loop is a submission of its own, because the
  // host poses the scene anew in between.
  bool first = true;
  std::vector<const Step*> pending;
  auto flush = [&] {
    submission_.run(pending, 0, 0, first && traces_ ? 1 : 0);
    first = false;
    pending.clear();
  };
  for (const Step& step : plan_->steps) {
    if (step.kind != Step::Kind::Loop) {
      pending.push_back(&step);
      continue;
    }
    flush();
    runLoop(setup, step, frame, result, on_iteration);
    scene_.setFrame(frame);
  }
  flush();
  images_.frameIsDrawn();
  collect(result);
  return result;
}

void Graph::runLoop(const FrameSetup& setup, const Step& step, shared::FrameData frame, FrameResult& result,
                    const std::function<void(int, int)>& on_iteration) {
  const plan::PlanLoop& loop = plan_->loops[size_t(step.index)];
  std::vector<const Step*> body;
  for (const Step& inner : step.body) body.push_back(&inner);
  frame.iteration_count = uint32_t(loop.parts);
  frame.slice_count = uint32_t(loop.slices);
  const bool traced = traces(*plan_, step.body);
  int iteration = 0;
  bool stop = false;
  while (iteration < loop.count && !stop) {
    poseSamples(scene_, *plan_, setup, loop, loop.first + iteration);
    frame.iteration = uint32_t(loop.first + iteration);
    frame.part = loop.until < 0 ? uint32_t(partOf(loop, loop.first + iteration)) : frame.iteration;
    scene_.setFrame(frame);
    submission_.run(body, iteration, SLICE_SAMPLE, traced ? uint32_t(loop.slices) : 0);
    ++iteration;
    if (loop.until >= 0) stop = static_cast<const float*>(images_.readBack(loop.until).mapped())[0] != 0;
    if (on_iteration) on_iteration(iteration, loop.count);
  }
  result.iterations.push_back({plan_->pipeline.loops[size_t(loop.loop)].name, iteration});
}

void Graph::collect(FrameResult& result) const {
  for (const auto& [name, image] : plan_->outputs)
    if (recording_.wants(name)) result.outputs[name] = images_.fetch(image);
  for (const auto& [name, image] : plan_->taps)
    if (recording_.wants(name)) result.taps[name] = images_.fetch(image);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const std::string& name = nodes_.name(i);
    const auto& counters = nodes_[i].pipeline->interface.counters;
    for (size_t c = 0; c < counters.size(); ++c)
      result.counters.push_back({name + "." + counters[c], nodes_[i].counts[c]});
    result.times.push_back({name, nodes_[i].gpu_ms, nodes_[i].executions});
  }
  result.gpu_ms = submission_.gpuMs();
}

}  // namespace strobe::graph
