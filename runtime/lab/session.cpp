// SPDX-License-Identifier: MIT
#include "lab/session.h"

#include <algorithm>
#include <future>

#include "base/hash.h"
#include "base/log.h"
#include "lab/session_version.h"
#include "plan/canonical.h"
#include "scene/motion.h"

namespace strobe::lab {

struct Session::Evaluated {
  plan::PipelineDesc pipeline;
  std::vector<script::Dependency> scripts;  // that were read; after a failure, those it read until then
  script::Texts texts;                      // of the scripts
  std::vector<script::Dependency> refused;  // newest files that failed, where older texts took their place
  std::vector<script::DroppedSetting> dropped;
  std::vector<std::string> problems;
  bool usable = false;
  double ms = 0;
};

struct Session::Changes {
  std::vector<std::string> files;  // as people know them
  bool scripts = false, scene = false;
  double ms = 0;
};

struct Session::Pending {
  Changes changes;
  Shot shot;                         // as it was when the evaluation began
  std::future<Evaluated> evaluated;  // its destructor waits
};

// ---- evaluation

// The texts of files, where they still are what was evaluated; others changed since, and the next look finds out.
static script::Texts textsOf(const std::vector<script::Dependency>& files, const script::Texts& given) {
  script::Texts texts;
  for (const auto& file : files) {
    auto held = given.find(file.path);
    if (held != given.end()) {
      texts.insert(*held);
      continue;
    }
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file.path, ignored)) continue;
    try {
      std::string text = readText(file.path);
      if (hashText(text) == file.hash) texts[file.path] = std::move(text);
    } catch (const Error&) {
      continue;
    }
  }
  return texts;
}

Session::Evaluated Session::evaluate(const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                                     bool lenient) {
  Evaluated evaluated;
  double started_s = clockSeconds();
  try {
    script::PipelineRequest request{shot.pipeline, shot.sets, texts};
    auto* dropped = lenient ? &evaluated.dropped : nullptr;
    evaluated.pipeline = script::evaluatePipeline(request, &evaluated.scripts, limits, dropped);
    evaluated.texts = textsOf(evaluated.scripts, texts);
    evaluated.usable = true;
  } catch (const std::exception& error) {  // an `Error`, or a folder that goes while it is listed
    evaluated.problems.push_back(error.what());
  }
  evaluated.ms = 1000 * (clockSeconds() - started_s);
  return evaluated;
}

// Of the files with a good text, those that say something else now.
static script::Texts changedTexts(const script::Texts& good) {
  script::Texts changed;
  for (const auto& [file, text] : good)
    if (script::hashOfPath(file) != hashText(text)) changed[file] = text;
  return changed;
}

// The newest files; where they fail, as many of them as work: files are put back to their last good text, those an
// error names first.
Session::Evaluated Session::evaluateAround(const Shot& shot, const script::Texts& good, const script::Limits& limits) {
  Evaluated newest = evaluate(shot, {}, limits, true);
  if (newest.usable || good.empty()) return newest;
  script::Texts changed = changedTexts(good), put_back;
  std::vector<std::string> problems = newest.problems;
  double ms = newest.ms;
  while (put_back.size() < changed.size()) {
    size_t before = put_back.size();
    for (const auto& [file, text] : changed)
      if (problems.back().find(displayPath(file)) != std::string::npos) put_back[file] = text;
    if (put_back.size() == before) put_back = changed;
    if (put_back.size() == changed.size()) break;  // nothing new is left to try
    Evaluated around = evaluate(shot, put_back, limits, true);
    ms += around.ms;
    problems.insert(problems.end(), around.problems.begin(), around.problems.end());
    if (!around.usable) continue;
    around.problems = problems;
    around.refused = newest.scripts;
    around.ms = ms;
    return around;
  }
  newest.problems = problems;
  newest.ms = ms;
  return newest;
}

// ---- versions

std::unique_ptr<Session::Version> Session::build(const Shot& shot, Evaluated evaluated,
                                                 std::vector<std::string>* problems) {
  auto version = std::make_unique<Version>();
  Shot filled = shot;
  version->scene = bench_.scene(filled);
  version->backend = bench_.chooseBackend(shot.backend);
  version->scripts = std::move(evaluated.scripts);
  version->texts = std::move(evaluated.texts);
  version->plan = std::make_unique<plan::Plan>(planOf(filled, evaluated.pipeline, version->backend));
  version->shape = plan::shapeOf(*version->plan);
  Shot untapped = filled;
  untapped.taps.clear();
  version->plan_hash = shot.taps.empty() ? plan::hashOf(*version->plan)
                                         : plan::hashOf(planOf(untapped, evaluated.pipeline, version->backend));

  uint32_t slices = SLICE_SAMPLE + graph::Graph::sampleSlices(*version->plan);
  version->on_device = version->scene->onDevice(bench_.device(), slices);

  bool same_shape = !problems && running_ && running_->shape == version->shape && running_->scene == version->scene &&
                    running_->backend == version->backend;
  if (same_shape) {
    version->graph = std::move(running_->graph);
    version->graph->setParams(*version->plan);
    return version;
  }
  const gpu::Device& device = bench_.device();
  std::vector<std::string> known;  // told when they were found
  if (running_) {
    version->graph = std::make_unique<graph::Graph>(device, bench_.pipelines(), *version->plan, *version->on_device,
                                                    version->backend, *running_->graph, problems ? *problems : known);
  } else {
    version->graph = std::make_unique<graph::Graph>(device, bench_.pipelines(), *version->plan, *version->on_device,
                                                    version->backend);
  }
  return version;
}

Session::Session(Workbench& bench, const Shot& shot, const std::string& origin)
    : bench_(bench), shot_(shot), given_by_(origin) {
  Evaluated evaluated;
  evaluated.pipeline = script::evaluatePipeline({shot.pipeline, shot.sets}, &evaluated.scripts, bench.limits);
  evaluated.texts = textsOf(evaluated.scripts, {});
  bench_.scene(shot_);
  rememberFiles(evaluated.scripts);
  running_ = build(shot_, std::move(evaluated), nullptr);
  rememberFiles(running_->scripts);
  for (const auto& [name, value] : shot.sets) origins_[name] = origin;
}

Session::~Session() = default;

Workbench& Session::bench() const { return bench_; }
const Shot& Session::shot() const { return shot_; }
const plan::Plan& Session::plan() const { return *running_->plan; }
const scene::Scene& Session::scene() const { return running_->scene->loaded.scene; }
graph::Backend Session::backend() const { return running_->backend; }
std::string Session::planHash() const { return running_->plan_hash; }
std::map<std::string, std::shared_ptr<const graph::NodePipeline>> Session::pipelines() const {
  return running_->graph->pipelines();
}
const std::vector<std::string>& Session::problems() const { return problems_; }

// ---- values

// The declaration of a shot's option with the choices that a scene gives it.
static plan::ParamDesc declarationOf(const ShotOption& option, const scene::Scene& scene) {
  plan::ParamDesc declared = option.declaration;
  if (declared.name == "camera") {
    for (const auto& node : scene.nodes)
      if (node.camera >= 0) declared.choices.push_back(node.name);
  }
  if (declared.name == "animation") {
    declared.choices = {"all", "none"};
    for (const auto& animation : scene.animations) declared.choices.push_back(animation.name);
  }
  return declared;
}

static const ShotOption* findOption(const std::string& name) {
  for (const ShotOption& option : shotOptions())
    if (option.declaration.name == name) return &option;
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

// Goes on with `shot`, on the scripts as they were when they were last good: a value has nothing to do with edits.
void Session::apply(const Shot& shot) {
  Evaluated evaluated = evaluate(shot, running_->texts, bench_.limits, false);
  if (!evaluated.usable) throw Error(evaluated.problems.front());
  Shot filled = shot;
  bench_.scene(filled);
  dropLostTaps(filled, evaluated.pipeline);
  running_ = build(filled, std::move(evaluated), nullptr);
  shot_ = filled;
  rememberFiles({});
}

// Options that only say how a frame sees the scene: neither the scene nor the plan depends on them.
static bool concernsTheFrameAlone(const std::string& name) {
  static const std::set<std::string> names = {"frame", "exposure", "anchor", "seed", "aa", "animation", "view"};
  return names.count(name) > 0;
}

void Session::set(const std::string& name, const std::string& value, const std::string& origin) {
  Shot shot = shot_;
  if (const ShotOption* option = findOption(name)) {
    plan::ParamDesc declared = declarationOf(*option, scene());
    // Nodes that the shot moves stay at rest where they were.
    bool moves = !shot.moves.empty() || !shot.spins.empty();
    if (name == "frame" && moves && shot.rest_frame < 0) shot.rest_frame = shot.frame;
    option->set(shot, plan::checkValue(declared, plan::Value(value), {}));
  } else if (name == "size") {
    auto [width, height] = parseSize(value);
    shot.width = width;
    shot.height = height;
  } else if (name == "view") {
    shot.view.reset();
    if (!value.empty()) shot.view = parseView(value);
  } else {
    putSetting(shot.sets, name, value);
  }
  if (concernsTheFrameAlone(name)) shot_ = shot;
  else apply(shot);
  for (const char* side : {"width", "height"})
    if (name == "size") origins_[side] = origin;
  if (name != "size") origins_[name] = origin;
}

void Session::unset(const std::string& name) {
  Shot shot = shot_, fresh;
  std::erase_if(shot.sets, [&](const auto& set) { return set.first == name; });
  if (const ShotOption* option = findOption(name)) {
    // What the scene suggests, else the default.
    fresh.scene = shot.scene;
    fillShot(fresh, running_->scene->loaded.description);
    option->set(shot, option->get(fresh));
  } else if (name == "view") {
    shot.view.reset();
  }
  apply(shot);
  origins_.erase(name);
}

void Session::tap(const std::vector<std::string>& ports) {
  Shot shot = shot_;
  shot.taps = ports;
  for (const std::string& port : ports)
    if (!hasPort(running_->plan->pipeline, port))
      throw Error(fmt::format("there is no image '{}'{}", port, didYouMean(port, this->ports())));
  if (shot.taps != shot_.taps) apply(shot);
}

std::vector<std::string> Session::ports() const {
  const plan::Plan& plan = *running_->plan;
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
    const std::string& name = option.declaration.name;
    Control control{declarationOf(option, scene()), option.get(shot_), "shot", origin_of(name), "", false};
    control.set = !control.origin.empty();
    bool first_camera = name == "camera" && shot_.camera.empty() && !control.declaration.choices.empty();
    if (first_camera) control.value = scene().nodes[size_t(scene::cameraNode(scene(), ""))].name;
    if (!control.set) control.origin = option.get(shot_) == option.get(defaults) ? "default" : given_by_ + " or scene";
    controls.push_back(control);
  }

  const plan::PipelineDesc& pipeline = running_->plan->pipeline;
  std::string preset;
  for (const auto& [name, value] : pipeline.values)
    if (const auto* text = std::get_if<std::string>(&value); text && name == "preset") preset = *text;
  for (size_t i = 0; i < pipeline.params.size(); ++i) {
    const plan::ParamDesc& declared = pipeline.params[i];
    auto value = std::find_if(pipeline.values.begin(), pipeline.values.end(),
                              [&](const auto& v) { return v.first == declared.name; });
    Control control{declared, value->second, "pipeline", origin_of(declared.name), declared.place.text(), false};
    control.set = !control.origin.empty();
    bool by_preset = !preset.empty() && !(value->second == declared.default_value);
    if (!control.set) control.origin = by_preset ? "preset " + preset : "default";
    controls.push_back(control);
  }
  for (const auto& node : running_->plan->nodes) {
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

// Of a file that is known already, what was noted when it was last tried stands: it may have changed since.
static void noteFile(std::map<Path, std::string>& tried, const Path& file) {
  if (!tried.count(file)) tried[file] = script::hashOfPath(file);
}

// Notes the state of all files that what runs (and what was tried) was made of, so that the next change is seen.
void Session::rememberFiles(const std::vector<script::Dependency>& more) {
  for (const auto& file : more) tried_[file.path] = file.hash;
  if (!running_) return;
  for (const auto& file : running_->scripts) tried_.emplace(file.path, file.hash);
  for (const auto& node : running_->plan->nodes) {
    for (const Path& file : graph::shaderFiles(running_->plan->pipeline.passes[size_t(node.pass)])) {
      std::vector<Path> reached = {file};
      try {
        shader::textWithIncludes(file, &reached);
      } catch (const Error&) {
        // Reported where it is compiled.
      }
      for (const Path& one : reached) noteFile(tried_, one);
    }
  }
  for (const auto& [node, pipeline] : running_->graph->pipelines())
    for (const Path& file : pipeline->files) noteFile(tried_, file);
  for (const auto& file : running_->scene->loaded.dependencies) tried_.emplace(file.path, file.hash);
  if (watch_) watchFolders();
}

void Session::watchFolders() {
  for (const char* folder : {"passes", "shaders", "scripts"}) watch_->add(homeFolder() / folder);
  for (const auto* files : {&running_->scripts, &running_->scene->loaded.dependencies})
    for (const auto& file : *files) watch_->addFlat(file.path.parent_path());
}

Session::Changes Session::lookAtFiles() {
  Changes changes;
  double started_s = clockSeconds();
  auto is_among = [](const std::vector<script::Dependency>& files, const Path& path) {
    return std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.path == path; });
  };
  for (auto& [path, hash] : tried_) {
    std::string now = script::hashOfPath(path);
    if (now == hash) continue;
    hash = now;
    changes.files.push_back(displayPath(path));
    // The library is of both; what is of neither was part of an attempt that failed.
    bool scene = is_among(running_->scene->loaded.dependencies, path);
    bool shader = path.extension() == ".glsl" || path.extension() == ".h";
    changes.scene |= scene;
    changes.scripts |= is_among(running_->scripts, path) || (!scene && !shader);
  }
  changes.ms = 1000 * (clockSeconds() - started_s);
  return changes;
}

std::optional<Reload> Session::reload(bool wait) {
  bool first = !watch_;
  if (first) {
    watch_ = std::make_unique<Watch>();
    watchFolders();
  }
  if (pending_) {
    bool done = wait || pending_->evaluated.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!done) return std::nullopt;
    std::unique_ptr<Pending> pending = std::move(pending_);
    Evaluated evaluated = pending->evaluated.get();
    // Values set in the meantime are not in what was evaluated.
    bool overtaken = shot_.pipeline != pending->shot.pipeline || shot_.sets != pending->shot.sets;
    if (!overtaken) return replace(shot_, std::move(evaluated), std::move(pending->changes));
    if (wait) return replace(shot_, evaluateAround(shot_, running_->texts, bench_.limits), std::move(pending->changes));
    evaluateInBackground(std::move(pending->changes));
    return std::nullopt;
  }
  bool event = watch_->changed();
  if (!event && !first && !wait) return std::nullopt;
  Changes changes = lookAtFiles();
  // After a failure a file that nothing could name yet may have appeared.
  bool retry = event && !problems_.empty();
  if (changes.files.empty() && !retry) return std::nullopt;
  changes.scripts |= script_problem_;
  if (!changes.scripts) {
    Evaluated same;
    same.pipeline = running_->plan->pipeline;
    same.scripts = running_->scripts;
    same.texts = running_->texts;
    same.usable = true;
    return replace(shot_, std::move(same), std::move(changes));
  }
  if (wait) return replace(shot_, evaluateAround(shot_, running_->texts, bench_.limits), std::move(changes));
  evaluateInBackground(std::move(changes));
  return std::nullopt;
}

void Session::evaluateInBackground(Changes changes) {
  auto evaluation = [shot = shot_, texts = running_->texts, limits = bench_.limits] {
    return evaluateAround(shot, texts, limits);
  };
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

// Puts a new version in the place of the running one, as far as it is sound, and tells what became of everything.
Reload Session::replace(Shot shot, Evaluated evaluated, Changes changes) {
  Reload told;
  told.changed = changes.files;
  told.notice_ms = changes.ms;
  told.evaluate_ms = evaluated.ms;
  told.problems = evaluated.problems;
  script_problem_ = !evaluated.problems.empty();
  std::vector<script::Dependency> tried = evaluated.scripts;
  tried.insert(tried.end(), evaluated.refused.begin(), evaluated.refused.end());
  if (!evaluated.usable) {
    evaluated.pipeline = running_->plan->pipeline;
    evaluated.scripts = running_->scripts;
    evaluated.texts = running_->texts;
    evaluated.dropped.clear();
  }
  for (const auto& dropped : evaluated.dropped) {
    std::erase_if(shot.sets, [&](const auto& set) { return set.first == dropped.name; });
    told.reset.push_back(fmt::format("{} = {}: {}", dropped.name, dropped.value, dropped.reason));
  }

  int compiled_before = bench_.compilations();
  double started_s = clockSeconds();
  std::map<std::string, std::shared_ptr<const graph::NodePipeline>> before = running_->graph->pipelines();
  std::vector<std::string> histories;
  for (const auto& image : running_->plan->images)
    if (image.history) histories.push_back(image.name);
  std::vector<std::string> problems;
  try {
    if (changes.scene) reloadScene(shot, problems);
    dropLostTaps(shot, evaluated.pipeline);
    auto version = build(shot, std::move(evaluated), &problems);
    for (const auto& [node, pipeline] : version->graph->pipelines()) {
      auto old = before.find(node);
      if (old == before.end() || old->second != pipeline) told.rebuilt.push_back(node);
    }
    bool new_scene = version->scene != running_->scene;
    bool new_plan = version->plan_hash != running_->plan_hash;
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
  told.compile_ms = running_->graph->compileMs();
  told.build_ms = spent_ms - told.compile_ms;

  for (const auto& [name, value] : shot_.sets) told.kept.push_back(name + " = " + value);
  std::vector<std::string> kept = running_->graph->histories(true);
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
  Evaluated evaluated = evaluate(shot, {}, bench_.limits, true);
  if (!evaluated.usable) throw Error(evaluated.problems.front());
  Reload told;
  for (const auto& dropped : evaluated.dropped) {
    std::erase_if(shot.sets, [&](const auto& set) { return set.first == dropped.name; });
    told.reset.push_back(fmt::format("{} = {}: {}", dropped.name, dropped.value, dropped.reason));
    origins_.erase(dropped.name);
  }
  std::vector<script::Dependency> tried = evaluated.scripts;
  running_ = build(shot, std::move(evaluated), &told.problems);
  shot_ = shot;
  for (const auto& [name, value] : shot_.sets) told.kept.push_back(name + " = " + value);
  told.changed = {running_->plan->pipeline.file};
  told.swapped = true;
  problems_ = told.problems;
  script_problem_ = false;
  rememberFiles(tried);
  return told;
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
