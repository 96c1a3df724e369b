// SPDX-License-Identifier: MIT
#include "graph/submission.h"

#include "base/log.h"

namespace strobe::graph {

using plan::Step;

Submission::Submission(const gpu::Device& device, const world::GpuScene& scene, const Recording& recording,
                       PlanNodes& nodes)
    : device_(device), scene_(scene), recording_(recording), nodes_(nodes) {
  stamps_.timer = gpu::Timer(device, uint32_t(2 * nodes.size() + 2));
}

void Submission::beginFrame() {
  gpu_ms_ = 0;
  for (Node& node : nodes_) node.beginFrame();
}

void Submission::run(const std::vector<const Step*>& steps, int iteration, uint32_t first_slice, uint32_t slice_count) {
  auto record_builds = [&](VkCommandBuffer commands) {
    for (uint32_t i = 0; i < slice_count; ++i) scene_.recordBuild(commands, first_slice + i);
  };
  if (device_.info().software) runStepwise(steps, iteration, slice_count, record_builds);
  else runStamped(steps, iteration, record_builds);
  for (Node& node : nodes_) node.takeCounts();
}

// Of the node that a step runs, "" for other steps.
std::string Submission::nameOf(const Step& step) const {
  return step.kind == Step::Kind::Pass ? nodes_.name(size_t(step.index)) : "";
}

// A software device compiles a shader when it is first used, which is not counted as its running. Work on no
// pixels at all compiles it and runs nothing, so that one that never ends is known as such. Drawing has no such thing.
static constexpr double kCompileAllowance_s = 120;

double Submission::compileBeforeUse(const Step& step) {
  if (step.kind != Step::Kind::Pass) return 0;
  const Node& node = nodes_[size_t(step.index)];
  if (std::exchange(node.pipeline->ran, true)) return 0;
  if (node.pipeline->interface.raster) return kCompileAllowance_s;
  auto record_nothing = [&](VkCommandBuffer commands) { recording_.emptyPass(commands, node); };
  device_.submit(record_nothing, nameOf(step), kCompileAllowance_s);
  return 0;
}

// A software device executes when something waits, against its time stamps: one submission per step, by the clock.
void Submission::runStepwise(const std::vector<const Step*>& steps, int iteration, uint32_t slice_count,
                             const Record& record_builds) {
  double start_s = clockSeconds();
  if (slice_count > 0) {
    device_.submit(record_builds);
    gpu_ms_ += 1000 * (clockSeconds() - start_s);
  }
  for (const Step* step : steps) {
    double allowance_s = compileBeforeUse(*step);
    start_s = clockSeconds();
    auto record_step = [&](VkCommandBuffer commands) {
      recording_.step(commands, *step, iteration, nullptr);
      recording_.hostBarrier(commands);
    };
    device_.submit(record_step, nameOf(*step), allowance_s);
    double ms = 1000 * (clockSeconds() - start_s);
    gpu_ms_ += ms;
    if (step->kind != Step::Kind::Pass) continue;
    nodes_[size_t(step->index)].gpu_ms += ms;
    ++nodes_[size_t(step->index)].executions;
  }
}

void Submission::runStamped(const std::vector<const Step*>& steps, int iteration, const Record& record_builds) {
  stamps_.pending.clear();
  std::string names;
  for (const Step* step : steps)
    if (step->kind == Step::Kind::Pass) names += (names.empty() ? "" : ", ") + nameOf(*step);
  auto record_all = [&](VkCommandBuffer commands) {
    stamps_.timer.recordReset(commands);
    stamps_.timer.recordStamp(commands);
    record_builds(commands);
    for (const Step* step : steps) recording_.step(commands, *step, iteration, &stamps_);
    stamps_.timer.recordStamp(commands);
    recording_.hostBarrier(commands);
  };
  device_.submit(record_all, names);
  std::vector<double> ms = stamps_.timer.readMs();
  gpu_ms_ += ms.back();
  for (const PassStamps::Pending& stamp : stamps_.pending) {
    nodes_[stamp.node].gpu_ms += ms[size_t(stamp.end)] - ms[size_t(stamp.begin)];
    ++nodes_[stamp.node].executions;
  }
}

}  // namespace strobe::graph
