// SPDX-License-Identifier: MIT
#include "graph/submission.h"

#include "base/log.h"

namespace strobe::graph {

using plan::Step;

Submission::Submission(const gpu::Device& device, const world::GpuScene& scene, const CommandRecording& recording,
                       PlanNodes& nodes, size_t frames)
    : device_(device), scene_(scene), recording_(recording), nodes_(nodes), frames_(frames) {
  for (Frame& frame : frames_) frame.staging = gpu::Staging(device);
}

void Submission::submit(size_t index, const Part& part) {
  Frame& frame = frames_[index];
  if (!isStepwise()) return submitPart(frame, part);
  if (!frame.staging.isEmpty() || part.slice_count > 0) {
    submitPart(frame, {{}, part.iteration, part.first_slice, part.slice_count});
    wait(index);
  }
  for (const Step* step : part.steps) {
    submitPart(frame, {{step}, part.iteration});
    wait(index);
  }
}

// Records the copies of host writes, then the builds of acceleration structures.
void Submission::recordScene(VkCommandBuffer commands, Frame& frame, const Part& part) const {
  frame.staging.recordCopies(commands);
  if (part.slice_count > 0) scene_.recordBuild(commands, part.first_slice, part.slice_count);
}

// Returns the name of a pass step's node; "" for other steps.
std::string Submission::nameOf(const Step& step) const {
  return step.kind == Step::Kind::Pass ? nodes_.name(size_t(step.index)) : "";
}

// Extra time limit for compiling a shader, seconds. A software device compiles a shader at its first use. An empty
// dispatch compiles the shader before the timed run, so that the run of an endless shader exceeds the normal limit. A
// raster pass has no empty dispatch; its first run gets the extra limit.
static constexpr double kCompileAllowance_s = 120;

double Submission::compileBeforeUse(const Step& step) {
  if (step.kind != Step::Kind::Pass) return 0;
  const GraphNode& node = nodes_[size_t(step.index)];
  if (std::exchange(node.pipeline->ran, true)) return 0;
  if (node.pipeline->interface.raster) return kCompileAllowance_s;
  auto record_nothing = [&](VkCommandBuffer commands) { recording_.emptyPass(commands, node); };
  device_.submit(record_nothing, nameOf(step), kCompileAllowance_s);
  return 0;
}

void Submission::submitPart(Frame& frame, const Part& part) {
  const uint32_t stamps = isStepwise() ? 0 : uint32_t(2 * nodes_.size() + 2);
  if (frame.pending == frame.parts.size())
    frame.parts.push_back({gpu::Commands(device_, "frame"), {gpu::Timer(device_, stamps), {}}});
  Submitted& submitted = frame.parts[frame.pending];
  submitted.stamps.pending.clear();
  submitted.names.clear();
  submitted.allowance_s = 0;
  for (const Step* step : part.steps) {
    if (step->kind != Step::Kind::Pass) continue;
    submitted.names += (submitted.names.empty() ? "" : ", ") + nameOf(*step);
    if (device_.info().software) submitted.allowance_s += compileBeforeUse(*step);
  }
  submitted.start_s = clockSeconds();
  submitted.commands.submit([&](VkCommandBuffer commands) {
    submitted.stamps.timer.recordReset(commands);
    recording_.frameBarrier(commands);
    submitted.stamps.timer.recordStamp(commands);
    recordScene(commands, frame, part);
    for (const Step* step : part.steps) recording_.step(commands, *step, part.iteration, submitted.stamps);
    submitted.stamps.timer.recordStamp(commands);
    recording_.hostBarrier(commands);
  });
  ++frame.pending;
}

void Submission::wait(size_t index) {
  Frame& frame = frames_[index];
  for (size_t i = 0; i < frame.pending; ++i) {
    Submitted& part = frame.parts[i];
    part.commands.wait(part.names, part.allowance_s);
    const double part_ms = 1000 * (clockSeconds() - part.start_s);
    const std::vector<double> ms = part.stamps.timer.readMs();  // empty if stepwise: the part has one step
    frame.gpu_ms += ms.empty() ? part_ms : ms.back();
    for (const PassStamps::Pending& stamp : part.stamps.pending) {
      NodeInFrame& node = nodes_[stamp.node].frames[index];
      node.gpu_ms += ms.empty() ? part_ms : ms[size_t(stamp.end)] - ms[size_t(stamp.begin)];
      ++node.executions;
    }
  }
  if (std::exchange(frame.pending, 0) == 0) return;
  frame.staging.reset();
  for (GraphNode& node : nodes_) node.frames[index].takeCounts();
}

}  // namespace strobe::graph
