// SPDX-License-Identifier: MIT
#include "lab/session.h"

#include <algorithm>
#include <utility>

#include "base/lists.h"
#include "base/log.h"
#include "lab/frame.h"
#include "plan/canonical.h"
#include "plan/filled_images.h"
#include "plan/named.h"
#include "plan/settings.h"

namespace strobe::lab {

// ---- versions

std::unique_ptr<Drawing> Session::build(const Shot& shot, std::shared_ptr<const Evaluation> evaluation,
                                        std::vector<std::string>* problems, bool whole) {
  Shot filled = shot;
  std::shared_ptr<HeldScene> scene = bench_.scene(filled);
  Planned planned = plannedOf(bench_, filled, scene.get(), evaluation->pipeline);
  return std::make_unique<Drawing>(bench_, scene, std::move(planned), std::move(evaluation), running_.get(), problems,
                                   whole);
}

Session::Session(Workbench& bench, const Shot& shot, const std::string& origin)
    : bench_(bench), shot_(shot), given_by_(origin), files_(bench) {
  std::shared_ptr<const Evaluation> evaluation = bench.evaluate(shot.pipeline, shot.sets);
  bench_.scene(shot_);
  running_ = build(shot_, evaluation, nullptr);
  files_.remember(*running_, evaluation->scripts, problems_.empty());
  for (const auto& [name, value] : shot.sets) origins_[name] = origin;
}

// ---- values

// Option with a field of this name, or with this name itself; null if not found. `field`: the field of this name, or
// null.
static const ShotOption* findOption(const std::string& name, const ShotField** field) {
  *field = nullptr;
  for (const ShotOption& option : shotOptions())
    for (const ShotField& one : option.fields) {
      bool is_value = one.isValue() && one.declaration.name == name;
      if (is_value) *field = &one;
      if (is_value || option.name == name) return &option;
    }
  return nullptr;
}

// Names of the writes and updates of a node; empty for an unknown node.
static std::vector<std::string> portsOf(const plan::PipelineDesc& pipeline, const std::string& name) {
  const plan::NodeDesc* node = plan::find(pipeline.nodes, name);
  return node ? plan::outputsOf(*plan::find(pipeline.passes, node->pass)) : std::vector<std::string>();
}

static bool hasPort(const plan::PipelineDesc& pipeline, const std::string& source) {
  size_t dot = source.find('.');
  if (dot == std::string::npos) return false;
  return contains(portsOf(pipeline, source.substr(0, dot)), source.substr(dot + 1));
}

// Drops the taps that the new graph lacks, so that a tap never prevents a change.
static void dropLostTaps(Shot& shot, const plan::PipelineDesc& pipeline) {
  std::erase_if(shot.taps, [&](const std::string& tap) { return !hasPort(pipeline, tap); });
}

// Pipeline settings in `to` that `from` lacks or that differ from `from`. No value if `to` lacks a pipeline setting of
// `from`.
static std::optional<script::Settings> added(const script::Settings& from, const script::Settings& to) {
  auto valueIn = [](const script::Settings& sets, const std::string& name) {
    const plan::Value* value = nullptr;
    for (const script::Setting& set : sets)
      if (set.first == name) value = &set.second;
    return value;
  };
  for (const script::Setting& set : from)
    if (!isOfScene(set) && !valueIn(to, set.first)) return std::nullopt;
  script::Settings changed;
  for (const script::Setting& set : to) {
    const plan::Value* before = valueIn(from, set.first);
    if (!isOfScene(set) && (!before || *before != set.second)) changed.push_back(set);
  }
  return changed;
}

// Evaluation of `shot` with the last good scripts, independent of later edits. The scripts run only if a value may
// decide the graph.
std::shared_ptr<const Evaluation> Session::evaluationOf(const Shot& shot) const {
  const Evaluation& now = running_->evaluation();
  std::optional<script::Settings> changed = added(shot_.sets, shot.sets);
  auto decides = [&](const script::Setting& set) { return plan::decidesGraph(now.pipeline, set.first); };
  if (changed && std::none_of(changed->begin(), changed->end(), decides)) try {
      return std::make_shared<Evaluation>(
          Evaluation{plan::withSettings(now.pipeline, *changed), now.scripts, now.texts});
    } catch (const Error&) {
      // Run the scripts below, for a better message.
    }
  Attempt evaluated = attempt(bench_.home(), shot, now.texts, bench_.limits, false);
  if (!evaluated.usable) throw Error(evaluated.problems.front());
  return std::make_shared<Evaluation>(std::move(evaluated.good));
}

void Session::apply(const Shot& shot) {
  std::shared_ptr<const Evaluation> evaluation = evaluationOf(shot);
  Shot filled = shot;
  bench_.scene(filled);
  dropLostTaps(filled, evaluation->pipeline);
  running_ = build(filled, evaluation, nullptr);
  shot_ = filled;
  files_.remember(*running_, {}, problems_.empty());
}

void Session::set(const std::string& name, const plan::Value& value, const std::string& origin) {
  Shot shot = shot_;
  const ShotField* field = nullptr;
  const ShotOption* option = findOption(name, &field);
  if (!option) {
    const std::string* typed = std::get_if<std::string>(&value);
    putSetting(shot.sets, name, typed ? plan::valueFromText(*typed) : value);
    apply(shot);
    origins_[name] = origin;
    return;
  }
  if (option->is(ShotOption::kNoPicture)) throw Error(fmt::format("'{}' cannot be changed here", name));
  // Keep the rest frame of nodes that the shot moves.
  bool moves = !shot.moves.empty() || !shot.spins.empty();
  if (name == "frame" && moves && shot.rest_frame < 0) shot.rest_frame = shot.frame;
  if (field) {
    ShotField offered = *field;
    offered.declaration = declarationOf(*field, scene());
    offered.set(shot, value);
  } else {
    setFromTexts(*option, shot, {plan::textOf(value)});
  }
  // A change of the frame alone needs no new plan if the facts stay equal.
  bool frame_alone = option->concern == Concern::Frame || option->concern == Concern::Motion;
  frame_alone = frame_alone && sceneIdentity(shot) == sceneIdentity(shot_);
  auto needs_no_plan = [&] {
    const plan::PipelineDesc& pipeline = plan().pipeline;
    return absentFacts(running_->held()->frame(shot, plan::earlierFrames(pipeline)), pipeline) == plan().absent;
  };
  if (frame_alone && needs_no_plan()) shot_ = shot;
  else apply(shot);
  if (field) origins_[name] = origin;
  for (const ShotField& one : option->fields)
    if (!field) origins_[one.declaration.name] = origin;
}

void Session::unset(const std::string& name) {
  Shot shot = shot_, fresh;
  const ShotField* field = nullptr;
  const ShotOption* option = findOption(name, &field);
  std::erase_if(shot.sets, [&](const auto& set) { return set.first == name; });
  if (option) {
    // Value that the scene suggests, otherwise the default.
    fillShot(fresh, running_->scene().description);
    fresh.scene = shot.scene;
    if (field) field->set(shot, field->get(fresh));
    else setFromJson(*option, shot, jsonOf(*option, fresh));
  }
  apply(shot);
  origins_.erase(name);
}

void Session::tap(const std::vector<std::string>& ports) {
  Shot shot = shot_;
  shot.taps = ports;
  for (const std::string& port : ports)
    if (!hasPort(running_->plan().pipeline, port))
      throw Error(fmt::format("unknown image '{}'{}", port, didYouMean(port, this->ports())));
  if (shot.taps != shot_.taps) apply(shot);
}

std::vector<std::string> Session::ports() const {
  std::vector<std::string> ports = plan::filledImages(plan());
  for (const plan::CulledNode& node : plan().culled)
    for (const std::string& port : node.by_facts ? portsOf(plan().pipeline, node.name) : std::vector<std::string>())
      ports.push_back(node.name + "." + port);
  return ports;
}

// ---- reload

void Session::drop(const std::vector<script::DroppedSetting>& dropped, Shot& shot, Reload& result) {
  for (const auto& one : dropped) {
    std::erase_if(shot.sets, [&](const auto& set) { return set.first == one.name; });
    result.reset.push_back(fmt::format("{} = {}: {}", one.name, one.value, one.reason));
  }
}

static void keepSettings(const Shot& shot, Reload& result) {
  for (const auto& [name, value] : shot.sets) result.kept.push_back(name + " = " + plan::textOf(value));
}

std::optional<Reload> Session::reload(bool wait) {
  auto changes = files_.look({shot_, *running_, !problems_.empty(), script_problem_}, wait);
  if (!changes) return std::nullopt;
  Attempt& evaluated = changes->evaluated;
  Reload result;
  result.changed = changes->files;
  result.evaluate_ms = evaluated.ms;
  result.problems = evaluated.problems;
  std::vector<script::Dependency> tried = evaluated.good.scripts;
  tried.insert(tried.end(), evaluated.refused.begin(), evaluated.refused.end());
  Shot shot = shot_;
  if (evaluated.usable) drop(evaluated.dropped, shot, result);
  auto evaluation =
      evaluated.usable ? std::make_shared<const Evaluation>(std::move(evaluated.good)) : running_->heldEvaluation();
  const bool whole = !wait && changes->mayBeUnfinished();
  if (!whole || result.problems.empty()) replace(shot, evaluation, changes->scene, whole, result);
  if (whole && !result.problems.empty()) {
    if (evaluated.usable) evaluated.good = *evaluation;
    files_.holdBack(std::move(*changes));
    files_.remember(*running_, tried, false);
    return std::nullopt;
  }
  script_problem_ = !evaluated.problems.empty();
  const bool are_dropped = shot_.sets == shot.sets;  // false if the running version was kept
  for (const auto& one : evaluated.dropped)
    if (are_dropped) origins_.erase(one.name);
  problems_ = result.problems;
  files_.remember(*running_, tried, problems_.empty());
  return result;
}

// Choices of parameters that `now` has and `before` lacks.
static std::vector<std::string> addedChoices(const plan::PipelineDesc& before, const plan::PipelineDesc& now) {
  std::vector<std::string> added;
  for (const plan::ParamDesc& param : now.params) {
    const plan::ParamDesc* known = plan::find(before.params, param.name);
    for (const std::string& choice : param.choices)
      if (known && !contains(known->choices, choice)) added.push_back(param.name + " = " + choice);
  }
  return added;
}

// Replaces the running version by the valid parts of a new version; with `whole`, only if all parts are valid. Reports
// kept and reset values and histories.
void Session::replace(Shot shot, const std::shared_ptr<const Evaluation>& evaluation, bool scene, bool whole,
                      Reload& result) {
  int compiled_before = bench_.compilations();
  double started_s = clockSeconds();
  auto before = running_->graph().pipelines();
  std::vector<std::string> histories, problems;
  for (const auto& image : running_->plan().images)
    if (image.history) histories.push_back(image.name);
  try {
    // If a scene file is invalid, the bench keeps the running scene.
    if (scene) try {
        bench_.scene(shot, true);
      } catch (const Error& error) {
        if (whole) throw;
        problems.push_back(error.what());
      }
    dropLostTaps(shot, evaluation->pipeline);
    auto version = build(shot, evaluation, &problems, whole);
    for (const auto& [node, pipeline] : version->graph().pipelines())
      if (!before.count(node) || before[node] != pipeline) result.rebuilt.push_back(node);
    bool new_scene = version->held() != running_->held();
    bool new_plan = version->planned().hash != running_->planned().hash;
    result.choices = addedChoices(running_->plan().pipeline, version->plan().pipeline);
    replaced_ = std::exchange(running_, std::move(version));
    shot_ = shot;
    result.swapped = new_scene || new_plan || !result.rebuilt.empty();
  } catch (const Error& error) {
    problems.push_back(error.what());
    result.reset.clear();
  }
  result.problems.insert(result.problems.end(), problems.begin(), problems.end());
  double spent_ms = 1000 * (clockSeconds() - started_s);
  result.compilations = bench_.compilations() - compiled_before;
  result.compile_ms = running_->graph().compileMs();
  result.build_ms = spent_ms - result.compile_ms;

  keepSettings(shot_, result);
  std::vector<std::string> kept = running_->graph().histories(true);
  for (const std::string& name : histories) {
    if (contains(kept, name)) result.kept.push_back("history " + name);
    else if (result.swapped) result.reset.push_back("history " + name + ": its declaration changed");
  }
}

Reload Session::usePipeline(const std::string& name_or_path) {
  Shot shot = shot_;
  shot.pipeline = name_or_path;
  shot.taps.clear();
  Attempt evaluated = attempt(bench_.home(), shot, {}, bench_.limits, true);
  if (!evaluated.usable) throw Error(evaluated.problems.front());
  Reload result;
  drop(evaluated.dropped, shot, result);
  std::vector<script::Dependency> tried = evaluated.good.scripts;
  running_ = build(shot, std::make_shared<Evaluation>(std::move(evaluated.good)), &result.problems);
  shot_ = shot;
  for (const auto& dropped : evaluated.dropped) origins_.erase(dropped.name);
  keepSettings(shot_, result);
  result.changed = {running_->plan().pipeline.file};
  result.swapped = true;
  problems_ = result.problems;
  script_problem_ = false;
  files_.remember(*running_, tried, problems_.empty());
  return result;
}

std::string textOf(const Reload& reload) {
  std::string files = fmt::format("{}", fmt::join(reload.changed, ", "));
  double ms = reload.evaluate_ms + reload.compile_ms + reload.build_ms;
  const bool taken = reload.swapped || reload.problems.empty();
  std::string text =
      fmt::format("{} {} ({}{} compiled, {:.0f} ms)", taken ? "reloaded" : "kept the last valid version of", files,
                  taken && !reload.swapped ? "same picture, " : "", reload.compilations, ms);
  for (const std::string& problem : reload.problems) text += "\n  " + problem;
  for (const std::string& choice : reload.choices) text += "\n  new choice " + choice;
  for (const std::string& kept : reload.kept) text += "\n  kept " + kept;
  for (const std::string& reset : reload.reset) text += "\n  reset " + reset;
  return text;
}

}  // namespace strobe::lab
