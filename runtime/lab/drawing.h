// SPDX-License-Identifier: MIT
// A shot ready to draw: scene on the device, plan, images and pipelines. Sessions, batches and renders use it.
#pragma once

#include "base/limit.h"
#include "lab/workbench.h"

namespace strobe::lab {

// A plan and values derived from it.
class Planned {
 public:
  std::shared_ptr<const plan::Plan> plan;
  std::string hash;  // identity of the pictures: hash of the plan with all facts and outputs, without taps
  graph::Backend backend = graph::Backend::None;

  // plan::shapeOf, computed at the first call. Not thread-safe.
  const std::string& shape() const;

 private:
  mutable std::string shape_;
};

// Plan of a shot without unset options, for the facts of its frame in `scene` (null: all facts hold) and for `outputs`
// (empty: all). Throws `Error`.
Planned plannedOf(const Workbench& bench, const Shot& shot, HeldScene* scene, const plan::PipelineDesc& pipeline,
                  const std::set<std::string>& outputs = {});

// Compiled frame graph of a shot with its scene on the device, ready to draw frames. Changes of parameters alone reuse
// the graph.
class Drawing {
 public:
  // Makes images and finds pipelines. Throws `Error` on failure. The bench must outlive the drawing.
  // `previous`: gives images and histories with equal descriptions to the new drawing, or its whole graph if the shape
  // is equal and `problems` is null. A shader that does not compile keeps its previous pipeline. `previous` must not be
  // used afterwards, unless the constructor throws.
  // `problems`: receives the compile errors. Null: errors are not reported, and shaders are not checked if the shape is
  // equal.
  // `whole`: throws `Error` if a shader does not compile.
  Drawing(Workbench& bench, std::shared_ptr<HeldScene> scene, Planned planned,
          std::shared_ptr<const Evaluation> evaluation, Drawing* previous = nullptr,
          std::vector<std::string>* problems = nullptr, bool whole = false);

  const plan::Plan& plan() const { return *planned_.plan; }
  const Planned& planned() const { return planned_; }
  const HeldScene& scene() const { return *scene_; }
  const std::shared_ptr<HeldScene>& held() const { return scene_; }
  const Evaluation& evaluation() const { return *evaluation_; }
  const std::shared_ptr<const Evaluation>& heldEvaluation() const { return evaluation_; }
  graph::Graph& graph() { return *graph_; }
  const graph::Graph& graph() const { return *graph_; }
  // True if `become` can take over the plan: same backend, scene and shape.
  bool fits(const Planned& planned, const HeldScene& scene) const;
  // Continues with a plan of the same shape. Only parameters change.
  void become(Planned planned, std::shared_ptr<const Evaluation> evaluation);

  // Draws the frame of `shot`, which must have the pipeline, settings, size and scene of this drawing. Reads back the
  // named outputs ("color") and taps ("node.port"); null: all.
  graph::FrameResult draw(const Shot& shot, const std::set<std::string>* outputs = nullptr,
                          const std::function<void(int done, int of)>& progress = {});
  // `draw` in two steps, to keep several frames in flight, at most graph::Graph::mostUnderWay. Frames finish in their
  // order of `begin`.
  void begin(const Shot& shot, const std::set<std::string>* outputs = nullptr);
  graph::FrameResult finish();
  // Draws the frame with sub-pixel samples, run record and timings; resets histories. `id_coverage`: counts the ids of
  // all samples; throws `Error` (exit code 2) for a pipeline without an integer output "id".
  Picture capture(const Shot& shot, const std::set<std::string>* outputs = nullptr,
                  const std::function<void(int done, int of)>& progress = {}, bool id_coverage = false);
  // Warnings about the limits that a drawn frame met, one line each: shot limits first, then pass limits.
  std::vector<LimitMet> limitsMet(const Shot& shot, const graph::FrameResult& frame) const;

 private:
  graph::Frame frameOf(const Shot& shot) const;

  Workbench& bench_;
  // Destruction is in reverse order: the graph before the objects that it uses.
  std::shared_ptr<HeldScene> scene_;
  std::shared_ptr<world::GpuScene> on_device_;
  Planned planned_;
  std::shared_ptr<const Evaluation> evaluation_;
  std::unique_ptr<graph::Graph> graph_;
};

}  // namespace strobe::lab
