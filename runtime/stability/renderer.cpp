// SPDX-License-Identifier: MIT
#include "stability/renderer.h"

#include "plan/canonical.h"

namespace strobe::stability {

static constexpr size_t kScenesHeld = 64;

std::string identityOf(const plan::Plan& plan) {
  Json json = plan::toJson(plan);
  for (const char* key : {"values", "pipeline", "culled"}) json.erase(key);
  return json.dump();
}

// Settings of the scene, or of the pipeline.
static std::string keyOf(const script::Settings& sets, bool of_scene) {
  std::string key;
  for (const auto& [name, value] : sets)
    if (name.starts_with("scene.") == of_scene) key += "|" + name + "=" + value;
  return key;
}

static script::Settings ofPipeline(const script::Settings& sets) {
  script::Settings result;
  for (const auto& set : sets)
    if (!set.first.starts_with("scene.")) result.push_back(set);
  return result;
}

const Evaluated& Renderer::evaluate(const std::string& pipeline, const script::Settings& sets) {
  auto [found, is_new] = evaluated_.emplace(pipeline + keyOf(sets, false), Evaluated());
  if (!is_new) return found->second;
  try {
    script::PipelineRequest request{pipeline, ofPipeline(sets)};
    found->second.pipeline =
        std::make_shared<plan::PipelineDesc>(script::evaluatePipeline(request, nullptr, bench_.limits));
  } catch (const Error& error) {
    found->second.refusal = error.what();
  }
  return found->second;
}

const Renderer::Planned& Renderer::planOf(const lab::Shot& shot, graph::Backend backend) {
  std::string key = fmt::format("{}x{}{}{}", shot.width, shot.height, shot.pipeline, keyOf(shot.sets, false));
  auto [found, is_new] = plans_.emplace(key, Planned());
  if (!is_new && found->second.plan) return found->second;
  const Evaluated& evaluated = evaluate(shot.pipeline, shot.sets);
  if (!evaluated.pipeline) throw Refusal(evaluated.refusal);
  auto plan = std::make_shared<plan::Plan>(lab::planOf(shot, *evaluated.pipeline, backend));
  found->second = {plan, identityOf(*plan)};
  return found->second;
}

std::shared_ptr<lab::HeldScene> Renderer::scene(lab::Shot& shot) {
  std::string key = shot.scene + keyOf(shot.sets, true);
  for (auto it = scenes_.begin(); it != scenes_.end(); ++it) {
    if (it->first != key) continue;
    scenes_.splice(scenes_.begin(), scenes_, it);
    lab::fillShot(shot, it->second->loaded.description);
    lab::checkShot(shot);
    return scenes_.front().second;
  }
  auto held = std::make_shared<lab::HeldScene>();
  held->loaded = lab::loadScene(shot);
  scenes_.emplace_front(key, held);
  if (scenes_.size() > kScenesHeld) scenes_.pop_back();
  return held;
}

void Renderer::forgetPicturesOf(const std::string& pipeline) {
  std::erase_if(pictures_, [&](const auto& held) { return held.first.starts_with(pipeline + "|"); });
}

std::shared_ptr<const image::Image> Renderer::color(const lab::Shot& wanted) {
  lab::Shot shot = wanted;
  graph::Backend backend = bench_.chooseBackend(shot.backend);
  std::shared_ptr<lab::HeldScene> held = scene(shot);
  const Planned& planned = planOf(shot, backend);
  std::string key = fmt::format("{}|{}|{}|{}|{}|{}|{}", shot.pipeline, planned.identity, shot.exposure, shot.anchor,
                                shot.frame, shot.seed, shot.scene + keyOf(shot.sets, true));
  auto known = pictures_.find(key);
  if (known != pictures_.end()) return known->second;

  uint32_t slices = SLICE_SAMPLE + graph::Graph::sampleSlices(*planned.plan);
  std::shared_ptr<scene::GpuScene> on_device = held->onDevice(bench_.device(), slices);
  graph::Graph graph(bench_.device(), bench_.pipelines(), *planned.plan, *on_device, backend);
  graph::FrameSetup setup = lab::frameSetup(shot, held->loaded.scene);
  const std::set<std::string> color = {"color"};
  setup.wanted = &color;
  graph::FrameResult frame = graph.run(setup);
  ++rendered_;
  auto picture = std::make_shared<const image::Image>(std::move(frame.outputs.at("color").floats));
  pictures_[key] = picture;
  return picture;
}

}  // namespace strobe::stability
