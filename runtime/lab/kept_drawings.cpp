// SPDX-License-Identifier: MIT
#include "lab/kept_drawings.h"

#include <algorithm>

#include "base/hash.h"

namespace strobe::lab {

KeptDrawings::Place KeptDrawings::find(const Planned& planned, const HeldScene& scene) {
  return std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.drawing->fits(planned, scene); });
}

Drawing& KeptDrawings::of(const std::shared_ptr<HeldScene>& scene, const Planned& planned,
                          std::shared_ptr<const Evaluation> evaluation) {
  auto found = find(planned, *scene);
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    kept_.front().drawing->become(planned, std::move(evaluation));
  } else {
    makeRoom(*planned.plan);
    kept_.push_front({std::make_unique<Drawing>(bench_, scene, planned, std::move(evaluation)), {}});
  }
  return *kept_.front().drawing;
}

// Evicts drawings before a new one is made, so that memory stays within the limits.
void KeptDrawings::makeRoom(const plan::Plan& plan) {
  size_t bytes = plan::bytesAliased(plan), count = 1;
  for (auto it = kept_.begin(); it != kept_.end(); ++count) {
    bytes += plan::bytesAliased(it->drawing->plan());
    bool goes = count >= most || bytes > most_bytes;
    it = goes ? kept_.erase(it) : std::next(it);
  }
}

// Stamps of the shader files of a graph. Empty if a file has changed since its compilation.
static std::optional<Stamps> shaderStamps(const graph::Graph& graph) {
  std::map<Path, std::string> compiled;
  for (const auto& [node, pipeline] : graph.pipelines())
    compiled.insert(pipeline->sources.begin(), pipeline->sources.end());
  Stamps stamps;
  for (const auto& [file, hash] : compiled) {
    stamps.add(file);
    if (script::hashOfPath(file) != hash) return {};
  }
  return stamps;
}

void KeptDrawings::dropIfStale(const Planned& planned, const HeldScene& scene) {
  auto found = find(planned, scene);
  if (found == kept_.end()) return;
  std::optional<Stamps>& shaders = found->shaders;
  if (shaders && shaders->current()) return;
  shaders = shaderStamps(found->drawing->graph());
  if (!shaders) kept_.erase(found);
}

Picture KeptDrawings::render(const Shot& shot, const std::function<void(int, int)>& progress, bool id_coverage) {
  Shot filled = shot;
  std::shared_ptr<const Evaluation> evaluation = bench_.evaluateNumbers(shot.pipeline, shot.sets);
  std::shared_ptr<HeldScene> scene = bench_.scene(filled, true);
  const Planned planned = plannedOf(bench_, filled, scene.get(), evaluation->pipeline);
  dropIfStale(planned, *scene);
  return of(scene, planned, std::move(evaluation)).capture(filled, nullptr, progress, id_coverage);
}

}  // namespace strobe::lab
