// SPDX-License-Identifier: MIT
#include "lab/batch.h"

#include <algorithm>

#include "base/hash.h"
#include "base/inputs.h"
#include "base/interruption.h"
#include "base/log.h"
#include "lab/frame.h"
#include "math/statistics.h"
#include "plan/canonical.h"
#include "shader/compiler.h"

namespace strobe::lab {

std::string identityOf(const plan::Plan& plan) {
  Json json = plan::toJson(plan);
  for (const char* key : {"values", "preset", "pipeline", "culled"}) json.erase(key);
  return json.dump();
}

const Batch::Evaluated& Batch::byScripts(const std::string& pipeline, const script::Settings& sets) {
  auto [found, is_new] = by_scripts_.emplace(pipeline + settingsIdentity(sets, false), Evaluated());
  if (!is_new) return found->second;
  try {
    found->second.evaluation = bench_.evaluate(pipeline, sets);
  } catch (const Error& error) {
    found->second.refusal = error.what();
  }
  return found->second;
}

const Batch::Evaluated& Batch::evaluated(const std::string& pipeline, const script::Settings& sets) {
  constexpr size_t kMost = 512;
  std::string key = pipeline + settingsIdentity(sets, false);
  auto known = derived_.find(key);
  if (known != derived_.end()) return known->second;
  if (derived_.size() >= kMost) derived_.clear();
  script::Settings of_pipeline = pipelineSettings(sets);
  auto by_scripts = [&](const script::Settings& deciding) { return byScripts(pipeline, deciding).evaluation; };
  std::shared_ptr<const Evaluation> evaluation = derivedEvaluation(of_pipeline, by_scripts);
  return derived_[key] = evaluation ? Evaluated{evaluation, ""} : byScripts(pipeline, of_pipeline);
}

std::shared_ptr<const Evaluation> Batch::accepted(const std::string& pipeline, const script::Settings& sets) {
  const Evaluated& result = evaluated(pipeline, sets);
  if (!result.evaluation) throw Refusal(result.refusal);
  return result.evaluation;
}

std::shared_ptr<const plan::PipelineDesc> Batch::evaluate(const std::string& pipeline, const script::Settings& sets) {
  std::shared_ptr<const Evaluation> evaluation = accepted(pipeline, sets);
  return {evaluation, &evaluation->pipeline};
}

bool Batch::accepts(const std::string& pipeline, const script::Settings& sets) {
  return evaluated(pipeline, sets).evaluation != nullptr;
}

const std::string& Batch::nameOf(plan::PipelineDesc::Kind kind) {
  std::string& name = names_[kind];
  if (name.empty()) name = script::pipelineOfKind(bench_.home(), kind, bench_.limits);
  return name;
}

Shot Batch::filled(const Shot& shot) {
  Shot filled = shot;
  bench_.scene(filled);
  return filled;
}

// ---- plans and drawings

const Batch::KnownPlan& Batch::known(const Shot& shot, HeldScene& scene, const Outputs& outputs) {
  constexpr size_t kMost = 512;
  const std::shared_ptr<const plan::PipelineDesc> pipeline = evaluate(shot.pipeline, shot.sets);
  const graph::Frame& frame = scene.frame(shot, plan::earlierFrames(*pipeline));
  std::string key = fmt::format("{}x{}|{}|{}|{}|{}|{}|{}", shot.width, shot.height, shot.backend, shot.pipeline,
                                settingsIdentity(shot.sets, false), fmt::join(shot.taps, ","),
                                fmt::join(absentFacts(frame, *pipeline), ","), fmt::join(outputs, ","));
  auto found = plans_.find(key);
  if (found != plans_.end()) return found->second;
  KnownPlan known{plannedOf(bench_, shot, &scene, *pipeline, outputs), ""};
  known.identity = identityOf(*known.planned.plan);
  if (plans_.size() >= kMost) plans_.clear();
  return plans_[key] = std::move(known);
}

std::shared_ptr<const plan::Plan> Batch::planOf(const Shot& wanted) {
  Shot shot = wanted;
  std::shared_ptr<HeldScene> scene = bench_.scene(shot);
  return known(shot, *scene).planned.plan;
}

const std::string& Batch::shadersOf(const plan::PassDesc& pass, graph::Backend backend) {
  auto [found, is_new] = shaders_.emplace(fmt::format("{}|{}", pass.shader, int(backend)), "");
  for (const Path& file : is_new ? graph::filesOf(bench_.home(), pass, backend) : std::vector<Path>()) {
    found->second += inputHash(file);
    inputs_.insert(file);
  }
  return found->second;
}

std::string Batch::contentOf(const Shot& wanted) {
  Shot shot = wanted;
  std::shared_ptr<HeldScene> scene = bench_.scene(shot);
  const Planned& planned = known(shot, *scene).planned;
  std::string shaders;
  for (const plan::PlanNode& node : planned.plan->nodes)
    shaders += shadersOf(planned.plan->passOf(node), planned.backend);
  const std::shared_ptr<const Evaluation> evaluation = accepted(shot.pipeline, shot.sets);
  for (const script::Dependency& file : evaluation->scripts) inputs_.insert(file.path);
  for (const script::Dependency& file : scene->dependencies) inputs_.insert(file.path);
  shot.scene.clear();
  return hashText(fmt::format("{}|{}|{}|{}|{}|{}{}", frameIdentity(shot), sceneIdentity(shot), scene->hash,
                              planned.hash, int(planned.backend), shaders, shot.model_everything ? "|everything" : ""));
}

Drawing& Batch::drawing(const Shot& shot, const std::shared_ptr<HeldScene>& scene, const Outputs& outputs) {
  const Planned& planned = known(shot, *scene, outputs).planned;
  return drawings.of(scene, planned, accepted(shot.pipeline, shot.sets));
}

static const Batch::Outputs kColor = {"color"}, kNothing = {};

// ---- pictures

static size_t bytesOf(const Picture& picture) {
  size_t bytes = 0;
  for (const auto* images : {&picture.frame.outputs, &picture.frame.taps})
    for (const auto& [name, read] : *images) bytes += 4 * (read.floats.values.size() + read.uints.values.size());
  return bytes;
}

void Batch::keep(Kept kept) {
  pictures_bytes_ += kept.bytes;
  pictures_.push_front(std::move(kept));
  while (pictures_bytes_ > kept_picture_bytes && pictures_.size() > 1) {
    pictures_bytes_ -= pictures_.back().bytes;
    pictures_.pop_back();
  }
}

std::shared_ptr<const Picture> Batch::picture(const Shot& wanted, const Outputs& outputs, const Progress& progress) {
  Shot shot = wanted;
  std::shared_ptr<HeldScene> scene = bench_.scene(shot);
  std::string key = fmt::format("{}|{}|{}", canonical(shot), fmt::join(shot.taps, ","), fmt::join(outputs, ","));
  auto held = std::find_if(pictures_.begin(), pictures_.end(), [&](const Kept& kept) { return kept.key == key; });
  if (held != pictures_.end()) {
    pictures_.splice(pictures_.begin(), pictures_, held);
    return held->picture;
  }
  std::shared_ptr<const Picture> picture;
  if (source && outputs.empty()) picture = source(contentOf(shot), progress);
  if (!picture)
    picture = std::make_shared<const Picture>(
        drawing(shot, scene, outputs).capture(shot, outputs.empty() ? nullptr : &outputs, progress));
  ++drawn_;
  keep({key, picture, bytesOf(*picture)});
  return picture;
}

void Batch::forgetColorsOf(const std::string& pipeline) {
  std::erase_if(colors_, [&](const auto& held) { return held.first.starts_with(pipeline + "|"); });
}

std::shared_ptr<const image::Image> Batch::color(const Shot& wanted) {
  Shot shot = wanted;
  std::shared_ptr<HeldScene> scene = bench_.scene(shot);
  std::string key = fmt::format("{}|{}|{}|{}", shot.pipeline, known(shot, *scene, kColor).identity, frameIdentity(shot),
                                sceneIdentity(shot));
  auto held = colors_.find(key);
  if (held != colors_.end()) return held->second;
  Drawing& drawn = drawing(shot, scene, kColor);
  drawn.graph().forgetHistories();
  graph::FrameResult frame = drawn.draw(shot, &kColor);
  ++drawn_;
  return colors_[key] = std::make_shared<const image::Image>(std::move(frame.outputs.at("color").floats));
}

// ---- times

static bool isKnown(const Timing& timing, double within) {
  Estimate middle = estimatedMedian(timing.ms);
  return middle.value - middle.low <= within * middle.value && middle.high - middle.value <= within * middle.value;
}

// A frame, and the wall time since the frame before.
struct Timed {
  graph::FrameResult frame;
  double interval_ms = 0;
};

// Draws and times one frame. With several frames in flight, the interval is the mean over the maximum number in flight,
// and this number stays in flight during the measurement.
static Timed timed(Drawing& drawing, const Shot& shot) {
  graph::Graph& graph = drawing.graph();
  graph.drop();
  const size_t most = graph.mostUnderWay(), before = most > 1 ? most : 0, after = before;
  double start_s = clockSeconds();
  size_t begun = 0;
  Timed result;
  for (size_t finished = 0; finished < before + most;) {
    for (; begun < before + most + after && graph.underWay() < most; ++begun) drawing.begin(shot, &kNothing);
    result.frame = drawing.finish();
    if (++finished == before) start_s = clockSeconds();
  }
  result.interval_ms = 1000 * (clockSeconds() - start_s) / double(most);
  graph.drop();
  return result;
}

static void addRound(Timing& timing, const Timed& drawn) {
  const graph::FrameResult& frame = drawn.frame;
  timing.ms.push_back(frame.gpu_ms);
  timing.interval_ms.push_back(drawn.interval_ms);
  if (timing.passes.empty())
    for (const graph::StepTime& step : frame.times) timing.passes.push_back({step.name, {}});
  for (size_t i = 0; i < timing.passes.size(); ++i) timing.passes[i].second.push_back(frame.times[i].gpu_ms);
  timing.executions.clear();
  for (const graph::StepTime& step : frame.times) timing.executions.push_back(step.executions);
  timing.counters = frame.counters;
}

std::vector<Timing> Batch::timeInTurn(const std::vector<Shot>& shots, const Rounds& rounds) {
  std::vector<Timing> timings(shots.size());
  auto known = [&](const Timing& timing) { return isKnown(timing, rounds.within); };
  for (int round = -1; round < rounds.most; ++round) {
    if (round >= rounds.least && std::all_of(timings.begin(), timings.end(), known)) break;
    for (size_t i = 0; i < shots.size(); ++i) {
      stopIfOverdue();
      Shot shot = shots[i];
      std::shared_ptr<HeldScene> scene = bench_.scene(shot);
      Timed drawn = timed(drawing(shot, scene, kColor), shot);
      if (round >= 0) addRound(timings[i], drawn);
    }
  }
  return timings;
}

}  // namespace strobe::lab
