// SPDX-License-Identifier: MIT
// A shot ready to be drawn: its scene on the device, its plan, the images and pipelines of that. What a session runs,
// what a batch keeps, what a picture is taken with.
#pragma once

#include "lab/workbench.h"

namespace strobe::lab {

// A plan with what is derived from it.
class Planned {
 public:
  std::shared_ptr<const plan::Plan> plan;
  std::string hash;  // identity of the pictures: of the plan with all facts and outputs, without taps
  graph::Backend backend = graph::Backend::None;

  // plan::shapeOf, computed at the first call. Not thread-safe.
  const std::string& shape() const;

 private:
  mutable std::string shape_;
};

// Of a shot whose gaps are filled, for what its frame requires of the scene and for the outputs asked for (empty: all).
// Throws `Error`.
Planned plannedOf(const Workbench& bench, const Shot& shot, const scene::Scene& scene,
                  const plan::PipelineDesc& pipeline, const std::set<std::string>& outputs = {});
// For any scene and all outputs: all facts hold.
Planned plannedOf(const Workbench& bench, const Shot& shot, const plan::PipelineDesc& pipeline);

class Drawing {
 public:
  // Makes images and finds pipelines; throws `Error` where that fails. With `previous`, images and histories that are
  // described alike are taken over from it, all of them where the shape is the same; a shader that does not compile
  // keeps the pipeline it had, and what is wrong is added to `problems` (may be null: such a shader is not looked at);
  // `whole`: such a shader is thrown as an `Error`. `previous` is good for nothing afterwards, unless this throws. The
  // bench must outlive it.
  Drawing(Workbench& bench, std::shared_ptr<HeldScene> scene, Planned planned,
          std::shared_ptr<const Evaluation> evaluation, Drawing* previous = nullptr,
          std::vector<std::string>* problems = nullptr, bool whole = false);

  const plan::Plan& plan() const { return *planned_.plan; }
  const Planned& planned() const { return planned_; }
  const LoadedScene& scene() const { return scene_->loaded; }
  const std::shared_ptr<HeldScene>& held() const { return scene_; }
  const Evaluation& evaluation() const { return *evaluation_; }
  const std::shared_ptr<const Evaluation>& heldEvaluation() const { return evaluation_; }
  graph::Graph& graph() { return *graph_; }
  const graph::Graph& graph() const { return *graph_; }
  // Whether a plan of a scene can be drawn by `become`.
  bool fits(const Planned& planned, const HeldScene& scene) const;
  // Goes on with a plan of the same shape: parameters alone change.
  void become(Planned planned, std::shared_ptr<const Evaluation> evaluation);

  // The frame of `shot`, whose pipeline, settings, size and scene are those this was made for; `outputs` ("color") and
  // taps ("node.port") are read back, null: all.
  graph::FrameResult draw(const Shot& shot, const std::set<std::string>* outputs = nullptr,
                          const std::function<void(int done, int of)>& progress = {});
  // The same in two steps, so that other frames are begun meanwhile, while fewer than the most are under way
  // (graph::Graph); they are finished in the order in which they began.
  void begin(const Shot& shot, const std::set<std::string>* outputs = nullptr);
  graph::FrameResult finish();
  // The frame with sub-pixel samples, run record and timings; histories begin anew. With `id_coverage` the ids of all
  // samples are counted; throws `Error` (exit code 2) for a pipeline without an output "id" of integers.
  Picture capture(const Shot& shot, const std::set<std::string>* outputs = nullptr,
                  const std::function<void(int done, int of)>& progress = {}, bool id_coverage = false);
  // The limits that a frame met as it was drawn, a line each: its shot's, then its passes'.
  std::vector<std::string> limitsMet(const Shot& shot, const graph::FrameResult& frame) const;

 private:
  Workbench& bench_;
  // Destroyed from the last: the graph goes before what it draws.
  std::shared_ptr<HeldScene> scene_;
  std::shared_ptr<world::GpuScene> on_device_;
  Planned planned_;
  std::shared_ptr<const Evaluation> evaluation_;
  std::unique_ptr<graph::Graph> graph_;
};

}  // namespace strobe::lab
