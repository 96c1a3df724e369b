// SPDX-License-Identifier: MIT
#include "lab/session.h"

#include <algorithm>
#include <future>

#include "base/hash.h"
#include "base/log.h"
#include "plan/canonical.h"
#include "plan/settings.h"
#include "scene/motion.h"

namespace strobe::lab {

struct Session::Changes {
  std::vector<std::string> files;  // as people know them
  bool scripts = false, scene = false;
  double ms = 0;
};

struct Session::Pending {
  Changes changes;
  Shot shot;                       // as it was when the evaluation began
  std::future<Attempt> evaluated;  // its destructor waits
};

// ---- versions

std::unique_ptr<Drawing> Session::build(const Shot& shot, std::shared_ptr<const Evaluation> evaluation,
                                        std::vector<std::string>* problems) {
  Shot filled = shot;
  std::shared_ptr<HeldScene> scene = bench_.scene(filled);
  Planned planned = plannedOf(bench_, filled, evaluation->pipeline);
  return std::make_unique<Drawing>(bench_, scene, std::move(planned), std::move(evaluation), running_.get(), problems);
}

Session::Session(Workbench& bench, const Shot& shot, const std::string& origin)
    : bench_(bench), shot_(shot), given_by_(origin) {
  std::shared_ptr<const Evaluation> evaluation = bench.evaluate(shot.pipeline, shot.sets);
  bench_.scene(shot_);
  rememberFiles(evaluation->scripts);
  running_ = build(shot_, evaluation, nullptr);
  rememberFiles(evaluation->scripts);
  for (const auto& [name, value] : shot.sets) origins_[name] = origin;
}

Session::~Session() = default;

Workbench& Session::bench() const { return bench_; }
const Shot& Session::shot() const { return shot_; }
const plan::Plan& Session::plan() const { return running_->plan(); }
const scene::Scene& Session::scene() const { return running_->scene().scene; }
graph::Backend Session::backend() const { return running_->planned().backend; }
std::string Session::planHash() const { return running_->planned().hash; }
std::map<std::string, std::shared_ptr<const graph::NodePipeline>> Session::pipelines() const {
  return running_->graph().pipelines();
}
const std::vector<std::string>& Session::problems() const { return problems_; }

// ---- values

// The declaration of a value of a shot with the choices that a scene gives it.
static plan::ParamDesc declarationOf(const ShotField& field, const scene::Scene& scene) {
  plan::ParamDesc declared = field.declaration;
  if (declared.name == "camera")
    for (const auto& node : scene.nodes)
      if (node.camera >= 0) declared.choices.push_back(node.name);
  if (declared.name == "animation") {
    declared.choices = {"all", "none"};
    for (const auto& animation : scene.animations) declared.choices.push_back(animation.name);
  }
  return declared;
}

// Presets as one choice, which is how they are set.
static plan::ParamDesc declarationOf(const std::vector<plan::PresetDesc>& presets) {
  plan::ParamDesc declared;
  declared.name = plan::kPresetSetting;
  declared.type = plan::ParamDesc::Type::Choice;
  declared.doc = "named set of values, which single settings override";
  for (const plan::PresetDesc& preset : presets) {
    declared.choices.push_back(preset.name);
    declared.values.emplace_back(preset.name, preset.doc);
    if (preset.is_default) declared.default_value = preset.name;
  }
  return declared;
}

// The option that has a value of this name, or is called so itself; or null. `field` (may be null) is the value.
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

static bool hasPort(const plan::PipelineDesc& pipeline, const std::string& source) {
  size_t dot = source.find('.');
  auto node = std::find_if(pipeline.nodes.begin(), pipeline.nodes.end(),
                           [&](const auto& n) { return n.name == source.substr(0, dot); });
  if (dot == std::string::npos || node == pipeline.nodes.end()) return false;
  auto pass =
      std::find_if(pipeline.passes.begin(), pipeline.passes.end(), [&](const auto& p) { return p.name == node->pass; });
  auto named = [&](const auto& port) { return port.name == source.substr(dot + 1); };
  return std::any_of(pass->writes.begin(), pass->writes.end(), named) ||
         std::any_of(pass->updates.begin(), pass->updates.end(), named);
}

// Looking never stops a change: what a graph of another shape does not have is not looked at any more.
static void dropLostTaps(Shot& shot, const plan::PipelineDesc& pipeline) {
  std::erase_if(shot.taps, [&](const std::string& tap) { return !hasPort(pipeline, tap); });
}

// The pipeline's settings of `to` that `from` has not or has otherwise; nothing where `to` lacks one that `from` has.
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

// What the scripts give for `shot`, as they were when they were last good: a value has nothing to do with edits. They
// run where a value may decide the graph.
std::shared_ptr<const Evaluation> Session::evaluationOf(const Shot& shot) const {
  const Evaluation& now = running_->evaluation();
  std::optional<script::Settings> changed = added(shot_.sets, shot.sets);
  auto decides = [&](const script::Setting& set) { return plan::decidesGraph(now.pipeline, set.first); };
  if (changed && std::none_of(changed->begin(), changed->end(), decides)) try {
      return std::make_shared<Evaluation>(
          Evaluation{plan::withSettings(now.pipeline, *changed), now.scripts, now.texts});
    } catch (const Error&) {
      // The scripts say better what is wrong.
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
  rememberFiles({});
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
  // Nodes that the shot moves stay at rest where they were.
  bool moves = !shot.moves.empty() || !shot.spins.empty();
  if (name == "frame" && moves && shot.rest_frame < 0) shot.rest_frame = shot.frame;
  if (field) ShotField{declarationOf(*field, scene()), field->member}.set(shot, value);
  else setFromTexts(*option, shot, {plan::textOf(value)});
  take(*option, shot);
  if (field) origins_[name] = origin;
  for (const ShotField& one : option->fields)
    if (!field) origins_[one.declaration.name] = origin;
}

// Goes on with a shot of which one option changed: drawn anew if that concerns the frame alone.
void Session::take(const ShotOption& option, const Shot& shot) {
  bool frame_alone = option.concern == Concern::Frame || option.concern == Concern::Motion;
  if (frame_alone && sceneIdentity(shot) == sceneIdentity(shot_)) shot_ = shot;
  else apply(shot);
}

void Session::unset(const std::string& name) {
  Shot shot = shot_, fresh;
  const ShotField* field = nullptr;
  const ShotOption* option = findOption(name, &field);
  std::erase_if(shot.sets, [&](const auto& set) { return set.first == name; });
  if (option) {
    // What the scene suggests, else the default.
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
      throw Error(fmt::format("there is no image '{}'{}", port, didYouMean(port, this->ports())));
  if (shot.taps != shot_.taps) apply(shot);
}

std::vector<std::string> Session::ports() const {
  const plan::Plan& plan = running_->plan();
  std::vector<std::string> names;
  for (const auto& node : plan.nodes)
    for (const auto* images : {&node.writes, &node.updates})
      for (int image : *images) names.push_back(plan.images[size_t(image)].name);
  return names;
}

std::vector<Control> Session::controls() const {
  std::vector<Control> controls;
  auto origin_of = [this](const std::string& name) {
    auto found = origins_.find(name);
    return found == origins_.end() ? "" : found->second;
  };
  Shot defaults;
  for (const ShotOption& option : shotOptions()) {
    if (!option.is(ShotOption::kControl)) continue;
    for (const ShotField& field : option.fields) {
      const std::string& name = field.declaration.name;
      Control control{declarationOf(field, scene()), field.get(shot_), "shot", origin_of(name), "", false};
      control.set = !control.origin.empty();
      bool first_camera = name == "camera" && shot_.camera.empty() && !control.declaration.choices.empty();
      if (first_camera) control.value = scene().nodes[size_t(scene::cameraNode(scene(), ""))].name;
      if (!control.set) control.origin = field.get(shot_) == field.get(defaults) ? "default" : given_by_ + " or scene";
      controls.push_back(control);
    }
  }

  const plan::PipelineDesc& pipeline = running_->plan().pipeline;
  if (!pipeline.presets.empty()) {
    Control control{declarationOf(pipeline.presets), pipeline.preset, "pipeline",
                    origin_of(plan::kPresetSetting), pipeline.file,   false};
    control.set = !control.origin.empty();
    if (!control.set) control.origin = "default";
    controls.push_back(control);
  }
  for (size_t i = 0; i < pipeline.params.size(); ++i) {
    const plan::ParamDesc& declared = pipeline.params[i];
    auto value = std::find_if(pipeline.values.begin(), pipeline.values.end(),
                              [&](const auto& v) { return v.first == declared.name; });
    Control control{declared, value->second, "pipeline", origin_of(declared.name), declared.place.text(), false};
    control.set = !control.origin.empty();
    bool by_preset = !pipeline.preset.empty() && !(value->second == declared.default_value);
    if (!control.set) control.origin = by_preset ? "preset " + pipeline.preset : "default";
    controls.push_back(control);
  }
  for (const auto& node : running_->plan().nodes) {
    const plan::NodeDesc& described = pipeline.nodes[size_t(node.node)];
    const plan::PassDesc& pass = pipeline.passes[size_t(node.pass)];
    for (size_t i = 0; i < pass.params.size(); ++i) {
      Control control{pass.params[i], node.params[i].second, described.name, "", pass.params[i].place.text(), false};
      control.declaration.name = described.name + "." + pass.params[i].name;
      control.origin = origin_of(control.declaration.name);
      control.set = !control.origin.empty();
      auto bound = std::find_if(described.params.begin(), described.params.end(),
                                [&](const auto& b) { return b.first == pass.params[i].name; });
      if (!control.set && bound != described.params.end() && !bound->second.follows.empty())
        control.origin = "follows " + bound->second.follows;
      else if (!control.set) control.origin = control.value == pass.params[i].default_value ? "default" : pipeline.file;
      controls.push_back(control);
    }
  }
  return controls;
}

// ---- reload

// Notes the state of all files that what runs (and what was tried) was made of, so that the next change is seen.
void Session::rememberFiles(const std::vector<script::Dependency>& more) {
  files_.tried(more);
  if (!running_) return;
  files_.add(running_->evaluation().scripts);
  for (const auto& node : running_->plan().nodes) {
    for (const Path& file : graph::shaderFiles(bench_.home(), running_->plan().pipeline.passes[size_t(node.pass)])) {
      std::vector<Path> reached = {file};
      try {
        shader::textWithIncludes(bench_.home(), file, &reached);
      } catch (const Error&) {
        // Reported where it is compiled.
      }
      for (const Path& one : reached) files_.add(one);
    }
  }
  for (const auto& [node, pipeline] : running_->graph().pipelines())
    for (const Path& file : pipeline->files) files_.add(file);
  files_.add(running_->scene().dependencies);
  if (files_.isWatching()) watchFolders();
}

// True the first time.
bool Session::watchFolders() {
  std::vector<Path> folders;
  for (const char* name : {"passes", "shaders", "scripts", "scripts/pipelines", "scripts/scenes"})
    for (const Path& folder : bench_.home().folders(name)) folders.push_back(folder);
  bool first = files_.watch(folders);
  for (const auto* files : {&running_->evaluation().scripts, &running_->scene().dependencies}) files_.watchFlat(*files);
  return first;
}

Session::Changes Session::lookAtFiles() {
  Changes changes;
  double started_s = clockSeconds();
  auto is_among = [](const std::vector<script::Dependency>& files, const Path& path) {
    return std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.path == path; });
  };
  for (const Path& path : files_.takeChanged()) {
    changes.files.push_back(bench_.home().shown(path));
    // The library is of both; what is of neither was part of an attempt that failed.
    bool scene = is_among(running_->scene().dependencies, path);
    bool shader = path.extension() == ".glsl" || path.extension() == ".h";
    changes.scene |= scene;
    changes.scripts |= is_among(running_->evaluation().scripts, path) || (!scene && !shader);
  }
  changes.ms = 1000 * (clockSeconds() - started_s);
  return changes;
}

std::optional<Reload> Session::reload(bool wait) {
  bool first = !files_.isWatching() && watchFolders();
  if (pending_) {
    bool done = wait || pending_->evaluated.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!done) return std::nullopt;
    std::unique_ptr<Pending> pending = std::move(pending_);
    Attempt evaluated = pending->evaluated.get();
    // Values set in the meantime are not in what was evaluated.
    bool overtaken = shot_.pipeline != pending->shot.pipeline || shot_.sets != pending->shot.sets;
    if (!overtaken) return replace(shot_, std::move(evaluated), std::move(pending->changes));
    if (wait)
      return replace(shot_, attemptAround(bench_.home(), shot_, running_->evaluation().texts, bench_.limits),
                     std::move(pending->changes));
    evaluateInBackground(std::move(pending->changes));
    return std::nullopt;
  }
  bool event = files_.event();
  if (!event && !first && !wait) return std::nullopt;
  Changes changes = lookAtFiles();
  // After a failure a file that nothing could name yet may have appeared.
  bool retry = event && !problems_.empty();
  if (changes.files.empty() && !retry) return std::nullopt;
  changes.scripts |= script_problem_;
  if (!changes.scripts) {
    Attempt same;
    same.good = running_->evaluation();
    same.usable = true;
    return replace(shot_, std::move(same), std::move(changes));
  }
  if (wait)
    return replace(shot_, attemptAround(bench_.home(), shot_, running_->evaluation().texts, bench_.limits),
                   std::move(changes));
  evaluateInBackground(std::move(changes));
  return std::nullopt;
}

void Session::evaluateInBackground(Changes changes) {
  auto evaluation = [&home = bench_.home(), shot = shot_, texts = running_->evaluation().texts,
                     limits = bench_.limits] { return attemptAround(home, shot, texts, limits); };
  pending_ = std::make_unique<Pending>(Pending{std::move(changes), shot_, std::async(std::launch::async, evaluation)});
}

// Has the bench hold the scene as its files are now; where they fail, it goes on holding the one that runs.
void Session::reloadScene(Shot& shot, std::vector<std::string>& problems) {
  try {
    bench_.scene(shot, true);
  } catch (const Error& error) {
    problems.push_back(error.what());
  }
}

static bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// Puts a new version in the place of the running one, as far as it is sound, and reports what became of everything.
Reload Session::replace(Shot shot, Attempt evaluated, Changes changes) {
  Reload told;
  told.changed = changes.files;
  told.notice_ms = changes.ms;
  told.evaluate_ms = evaluated.ms;
  told.problems = evaluated.problems;
  script_problem_ = !evaluated.problems.empty();
  std::vector<script::Dependency> tried = evaluated.good.scripts;
  tried.insert(tried.end(), evaluated.refused.begin(), evaluated.refused.end());
  if (!evaluated.usable) {
    evaluated.good = running_->evaluation();
    evaluated.dropped.clear();
  }
  for (const auto& dropped : evaluated.dropped) {
    std::erase_if(shot.sets, [&](const auto& set) { return set.first == dropped.name; });
    told.reset.push_back(fmt::format("{} = {}: {}", dropped.name, dropped.value, dropped.reason));
  }

  int compiled_before = bench_.compilations();
  double started_s = clockSeconds();
  std::map<std::string, std::shared_ptr<const graph::NodePipeline>> before = running_->graph().pipelines();
  std::vector<std::string> histories;
  for (const auto& image : running_->plan().images)
    if (image.history) histories.push_back(image.name);
  std::vector<std::string> problems;
  try {
    if (changes.scene) reloadScene(shot, problems);
    dropLostTaps(shot, evaluated.good.pipeline);
    auto version = build(shot, std::make_shared<Evaluation>(std::move(evaluated.good)), &problems);
    for (const auto& [node, pipeline] : version->graph().pipelines()) {
      auto old = before.find(node);
      if (old == before.end() || old->second != pipeline) told.rebuilt.push_back(node);
    }
    bool new_scene = version->held() != running_->held();
    bool new_plan = version->planned().hash != running_->planned().hash;
    running_ = std::move(version);
    shot_ = shot;
    told.swapped = new_scene || new_plan || !told.rebuilt.empty();
  } catch (const Error& error) {
    problems.push_back(error.what());
    told.reset.clear();
  }
  told.problems.insert(told.problems.end(), problems.begin(), problems.end());
  double spent_ms = 1000 * (clockSeconds() - started_s);
  told.compilations = bench_.compilations() - compiled_before;
  told.compile_ms = running_->graph().compileMs();
  told.build_ms = spent_ms - told.compile_ms;

  for (const auto& [name, value] : shot_.sets) told.kept.push_back(name + " = " + plan::textOf(value));
  std::vector<std::string> kept = running_->graph().histories(true);
  for (const std::string& name : histories) {
    if (contains(kept, name)) told.kept.push_back("history " + name);
    else if (told.swapped) told.reset.push_back("history " + name + ": described differently");
  }
  for (const auto& name : told.reset) origins_.erase(name.substr(0, name.find(" = ")));
  problems_ = told.problems;
  rememberFiles(tried);
  return told;
}

Reload Session::usePipeline(const std::string& name_or_path) {
  Shot shot = shot_;
  shot.pipeline = name_or_path;
  shot.taps.clear();
  Attempt evaluated = attempt(bench_.home(), shot, {}, bench_.limits, true);
  if (!evaluated.usable) throw Error(evaluated.problems.front());
  Reload told;
  for (const auto& dropped : evaluated.dropped) {
    std::erase_if(shot.sets, [&](const auto& set) { return set.first == dropped.name; });
    told.reset.push_back(fmt::format("{} = {}: {}", dropped.name, dropped.value, dropped.reason));
    origins_.erase(dropped.name);
  }
  std::vector<script::Dependency> tried = evaluated.good.scripts;
  running_ = build(shot, std::make_shared<Evaluation>(std::move(evaluated.good)), &told.problems);
  shot_ = shot;
  for (const auto& [name, value] : shot_.sets) told.kept.push_back(name + " = " + plan::textOf(value));
  told.changed = {running_->plan().pipeline.file};
  told.swapped = true;
  problems_ = told.problems;
  script_problem_ = false;
  rememberFiles(tried);
  return told;
}

// ---- frames

graph::FrameResult Session::draw(const std::set<std::string>* outputs, const std::function<void(int, int)>& progress) {
  return running_->draw(shot_, outputs, progress);
}

std::vector<std::string> Session::limitsMet(const graph::FrameResult& frame) const {
  return running_->limitsMet(shot_, frame);
}

Picture Session::capture(const std::function<void(int, int)>& progress) {
  return running_->capture(shot_, nullptr, progress);
}

std::string textOf(const Reload& reload) {
  std::string files = fmt::format("{}", fmt::join(reload.changed, ", "));
  double ms = reload.evaluate_ms + reload.compile_ms + reload.build_ms;
  const char* what = reload.swapped ? "reloaded" : reload.problems.empty() ? "nothing new in" : "kept the last good";
  std::string text = fmt::format("{} {} ({} compiled, {:.0f} ms)", what, files, reload.compilations, ms);
  for (const std::string& problem : reload.problems) text += "\n  " + problem;
  for (const std::string& kept : reload.kept) text += "\n  kept " + kept;
  for (const std::string& reset : reload.reset) text += "\n  reset " + reset;
  return text;
}

}  // namespace strobe::lab
