// SPDX-License-Identifier: MIT
#include "study/experiment.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <tuple>

#include "base/hash.h"
#include "base/inputs.h"
#include "base/lists.h"
#include "lab/shot_data.h"
#include "lab/shot_options.h"
#include "lab/workbench.h"
#include "study/results.h"

namespace strobe::study {

namespace {

const std::vector<std::string> kDefaultRegions = {"whole", "inner", "hidden", "outer"};

Place placeFrom(const Json& json) { return {json.at("file").get<std::string>(), json.at("line").get<int>()}; }

// Places of an entry and of the settings in these lists. Settings of a scene get the prefix "scene.".
Written writtenIn(const Json& json, const std::vector<const char*>& lists) {
  Written written;
  if (json.contains("place")) written.place = placeFrom(json["place"]);
  for (const char* list : lists)
    for (const Json& one : json.value(list, Json::array())) {
      std::string prefix = std::string(list).starts_with("scene") ? "scene." : "";
      if (one.contains("place")) written.settings[prefix + one.at("name").get<std::string>()] = placeFrom(one["place"]);
    }
  return written;
}

StudiedArm armOf(const Json& json, const Path& script) {
  StudiedArm arm{{lab::armFrom(json, script)}};
  arm.written = writtenIn(json, {"set", "box", "full"});
  take(json, "lacks", arm.lacks);
  take(json, "shown", arm.shown);
  if (json.contains("timed")) arm.timed = json["timed"].get<bool>();
  arm.box = lab::settingsFrom(json, "box");
  if (json.value("role", "") == "floor") arm.role = ArmRole::floor;
  if (json.contains("published")) {
    const Json& published = json["published"];
    arm.published = Published{published.at("fps"), published.at("shot"), published.at("by")};
  }
  return arm;
}

Crop cropOf(const Json& json) {
  if (json.is_string()) return std::nullopt;
  std::array<double, 4> n = json.get<std::array<double, 4>>();
  return image::Rectangle{int(n[0]), int(n[1]), int(n[2]), int(n[3])};
}

StudiedShot shotOf(const Home& home, const Json& json, const Path& script, uint32_t seed) {
  StudiedShot result;
  takeTexts(json, result);
  result.written = writtenIn(json, {"scene_set", "options", "truth"});
  if (result.title.empty()) result.title = result.name;
  take(json, "picture_aa", result.picture_aa);
  result.tone = lab::toneFrom(json);
  result.truth = lab::settingsFrom(json, "truth");
  result.shot.seed = seed;
  lab::setOptions(result.shot, json.at("options"));
  result.shot.sets = lab::settingsFrom(json, "scene_set", "scene.");
  for (const Json& crop : json.value("crops", Json::array({"inner"}))) result.wanted_crops.push_back(cropOf(crop));
  result.frames = lab::framesFrom(json);
  if (!result.frames.empty()) result.shot.frame = result.frames.front();
  lab::SceneFile scene = lab::sceneFile(home, lab::besideScript(script, result.shot.scene));
  result.shot.scene = scene.scene, result.shared = scene.shared, result.missing = scene.missing;
  return result;
}

AxisValue valueOf(const Json& json) {
  AxisValue value;
  value.written = writtenIn(json, {"scene", "options", "set", "truth"});
  value.options = json.at("options");
  value.scene = lab::settingsFrom(json, "scene", "scene.");
  value.sets = lab::settingsFrom(json, "set");
  value.truth = lab::settingsFrom(json, "truth");
  return value;
}

Cost costOf(const Json& json) {
  return {json.at("part"), json.value("arm", ""), json.at("grows"), json.value("why", "")};
}

Axis axisOf(const Json& json) {
  Axis axis;
  takeTexts(json, axis);
  if (axis.title.empty()) axis.title = axis.name;
  take(json, "same_picture", axis.same_picture);
  take(json, "against", axis.against);
  for (const Json& cost : json.value("costs", Json::array())) axis.costs.push_back(costOf(cost));
  if (json.contains("benign_index")) axis.benign = json["benign_index"].get<size_t>() - 1;
  for (const Json& value : json.at("values")) {
    axis.values.push_back(value.at("value"));
    axis.labels.push_back(value.value("label", ""));
    axis.settings.push_back(valueOf(value));
  }
  return axis;
}

Group groupOf(const Json& json) {
  Group group;
  group.shot = json.at("shot").get<size_t>() - 1;
  for (const Json& at : json.at("at"))
    group.at.push_back({at.at("axis").get<size_t>() - 1, at.at("value").get<size_t>() - 1});
  for (const Json& arm : json.at("arms")) group.arms.push_back(arm.get<size_t>() - 1);
  return group;
}

Experiment experimentOf(const Home& home, const Json& json, const Path& script) {
  Experiment experiment;
  take(json, "title", experiment.title);
  take(json, "question", experiment.question);
  take(json, "note", experiment.note);
  take(json, "size_params", experiment.size_params);
  take(json, "rounds", experiment.rounds.least);
  experiment.rounds.most = json.value("most_rounds", experiment.rounds.least);
  take(json, "within", experiment.rounds.within);
  take(json, "base", experiment.base);
  take(json, "expectations", experiment.expectations);
  std::array<int, 2> size = json.value("size", std::array<int, 2>{960, 540});
  experiment.width = experiment.file_width = size[0], experiment.height = experiment.file_height = size[1];
  experiment.regions = json.value("regions", kDefaultRegions);
  experiment.measures = json.value("measures", std::vector<std::string>{"rmse", "flip", "ms"});
  for (const Json& arm : json.at("arms")) experiment.arms.push_back(armOf(arm, script));
  for (const Json& shot : json.at("shots"))
    experiment.shots.push_back(shotOf(home, shot, script, json.value("seed", 0u)));
  experiment.truth = armOf(json.at("truth"), script);
  experiment.truth.role = ArmRole::truth;
  if (json.at("truth").contains("full")) experiment.full_truth = lab::settingsFrom(json.at("truth"), "full");
  for (const Json& axis : json.at("axes")) experiment.axes.push_back(axisOf(axis));
  for (const Json& group : json.at("groups")) experiment.groups.push_back(groupOf(group));
  if (json.contains("background")) {
    const Json& back = json["background"];
    experiment.background = Background{back.at("arm"), back.at("color"), back.at("valid"), back.at("front")};
  }
  experiment.layout = layoutFrom(json.value("layout", Json::object()));
  return experiment;
}

// ---- checks

// Text that decides whether settings are accepted: names, and values that are texts. Numbers out of range are found
// later, when their point is drawn.
std::string formOf(const lab::Shot& shot, bool of_scene) {
  std::string form = of_scene ? shot.scene : shot.pipeline;
  if (of_scene)
    form += fmt::format("|{}|{}|{}|{}|{}", shot.camera, shot.animation, shot.follow, fmt::join(shot.moves, " "),
                        fmt::join(shot.spins, " "));
  for (const script::Setting& set : shot.sets) {
    if (lab::isOfScene(set) != of_scene) continue;
    form += "|" + set.first + "=";
    if (const auto* text = std::get_if<std::string>(&set.second)) form += *text;
  }
  return form;
}

// Entries of an experiment that determine one picture; later entries take precedence.
class Origin {
 public:
  void add(const Written& written, const std::string& what) { entries_.push_back({&written, what, false}); }
  void addAxes(const Experiment& experiment, const Group& group, const std::string& of) {
    for (const At& at : group.at) {
      const Axis& axis = experiment.axes[at.axis];
      entries_.push_back({&axis.settings[at.value].written, fmt::format("axis '{}', {}", axis.name, of), true});
    }
  }

  // Lines of an error message. A line about an option, or without a place, gets the place of its setting, or of the
  // first entry.
  std::vector<std::string> placed(const Error& error) const {
    const std::string& file = error.place().file;
    if (!file.empty() && !file.starts_with("--")) return {error.what()};
    std::vector<std::string> lines;
    std::istringstream text(error.what());
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    for (std::string& line : lines)
      if (line.starts_with("--") || lines.size() == 1) line = placed(line);
    return lines;
  }

 private:
  struct Entry {
    const Written* written;
    std::string what;
    bool of_axis;
  };

  // Name of the setting in a message: "tap" for "--set tap=4: ...", "camera" for "--camera x: ...", else "".
  static std::string settingIn(const std::string& message) {
    size_t start = message.starts_with("--set ") ? 6 : 2;
    return message.starts_with("--") ? message.substr(start, message.find_first_of(" =", start) - start) : "";
  }

  std::string placed(const std::string& message) const {
    const std::string name = settingIn(message);
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
      auto found = entry->written->settings.find(name);
      if (found == entry->written->settings.end()) continue;
      bool may_lack = entry->of_axis && message.find("has no parameter") != std::string::npos;
      std::string hint = may_lack ? fmt::format("; lacks = {{ \"{}\" }} draws the arm without it", name) : "";
      return Error(entry->what + ": " + message + hint, found->second).what();
    }
    return Error(entries_.front().what + ": " + message, entries_.front().written->place).what();
  }

  std::vector<Entry> entries_;  // not empty
};

template <class Step>
void collect(std::vector<std::string>& problems, const Origin& origin, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    for (const std::string& line : origin.placed(error)) addOnce(problems, line);
  }
}

class ExperimentReader {
 public:
  ExperimentReader(const Home& home, std::vector<std::string>& problems) : home_(home), problems_(problems) {}

  void pipeline(const lab::Shot& shot, const Origin& origin) {
    if (!known_.insert(formOf(shot, false)).second) return;
    pipelines_.push_back({shot.pipeline, shot.sets});
    origins_.push_back(origin);
  }
  void scene(lab::Shot shot, const Origin& origin) {
    if (!known_.insert("scene " + formOf(shot, true)).second) return;
    collect(problems_, origin, [&] { lab::loadScene(home_, shot); });
  }
  // Evaluates the pipelines; their problems follow the problems of scenes.
  void finish() {
    auto outcomes = script::evaluatePipelines(home_, pipelines_);
    for (size_t i = 0; i < outcomes.size(); ++i) collect(problems_, origins_[i], [&] { outcomes[i].take(); });
  }

 private:
  const Home& home_;
  std::vector<std::string>& problems_;
  std::set<std::string> known_;
  std::vector<script::PipelineRequest> pipelines_;
  std::vector<Origin> origins_;  // one per pipeline
};

void evaluateAll(const Home& home, const Experiment& experiment, std::vector<std::string>& problems) {
  ExperimentReader evaluation(home, problems);
  auto with = [](lab::Shot shot, const script::Settings& more) {
    shot.sets = joined(shot.sets, more);
    return shot;
  };
  for (const Group& group : experiment.groups) {
    lab::Shot truth = truthShotOf(experiment, group);
    for (size_t number : group.arms) {
      const StudiedArm& arm = experiment.arms[number];
      Origin origin;
      origin.add(arm.written, fmt::format("arm '{}'", arm.name));
      origin.addAxes(experiment, group, fmt::format("arm '{}'", arm.name));
      for (const script::Settings& more : {script::Settings(), arm.box})
        evaluation.pipeline(with(shotOf(experiment, group, arm), more), origin);
    }
    const StudiedShot& studied = experiment.shots[group.shot];
    Origin of_truth, of_scene;
    of_truth.add(experiment.truth.written, "truth");
    of_scene.add(studied.written, fmt::format("shot '{}'", studied.name));
    of_truth.add(studied.written, fmt::format("shot '{}', truth", studied.name));
    of_truth.addAxes(experiment, group, "truth");
    of_scene.addAxes(experiment, group, fmt::format("shot '{}'", studied.name));
    evaluation.pipeline(truth, of_truth);
    if (experiment.full_truth) evaluation.pipeline(truthShotOf(experiment, group, *experiment.full_truth), of_truth);
    if (studied.missing.empty()) evaluation.scene(truth, of_scene);
  }
  evaluation.finish();
}

void check(const Home& home, const Experiment& experiment, const std::string& file, bool evaluate) {
  std::vector<std::string> problems;
  auto refuse = [&](const std::string& text) { problems.push_back(Error(text, {file}).what()); };
  const auto [shorter, longer] = std::minmax(experiment.width, experiment.height);
  if (shorter < 1 || longer > plan::kMaxSide) refuse(fmt::format("size must be 1 to {} pixels", plan::kMaxSide));
  const lab::Rounds& rounds = experiment.rounds;
  if (rounds.least < 1 || rounds.most > 10000 || rounds.most < rounds.least)
    refuse("rounds and most_rounds must be 1 to 10000, and rounds at most most_rounds");
  for (const StudiedShot& shot : experiment.shots)
    if (shot.picture_aa < 1 || shot.picture_aa > 256) refuse("picture_aa must be 1 to 256");
  bool has_sequence = std::any_of(experiment.shots.begin(), experiment.shots.end(),
                                  [](const StudiedShot& shot) { return !shot.frames.empty(); });
  for (const std::string& name : experiment.measures)
    if (measureNamed(name).needs == Needs::before && !has_sequence)
      refuse(fmt::format("measure '{}' needs a shot with frames = {{ from, to, step }}", name));
  throwIfAny(problems);
  if (evaluate) evaluateAll(home, experiment, problems);
  throwIfAny(problems);
}

// Large enough to list and judge thousands of points in one evaluation.
const script::Limits kLimits = {.cpu_s = 60, .wall_s = 240, .memory_mb = 1024};

// Known names, to check the names in a file.
Json given() {
  return {{"options", lab::shotOptionsJson()},
          {"regions", regionNames()},
          {"measures", measureNames()},
          {"default_regions", kDefaultRegions}};
}

}  // namespace

std::string nameOf(ArmRole role) {
  return role == ArmRole::truth ? "truth" : role == ArmRole::floor ? "floor" : "method";
}

size_t Experiment::points() const {
  size_t count = 0;
  for (const Group& group : groups) count += group.arms.size();
  return count;
}

size_t Experiment::truths() const {
  std::set<std::string> commands;
  for (const Group& group : groups) commands.insert(commandOf(shots[group.shot], truthShotOf(*this, group)));
  return countTruths(commands);
}

std::vector<size_t> sharesOf(const Experiment& experiment, size_t of) {
  std::vector<std::string> truths;
  std::map<std::string, size_t> points;
  for (const Group& group : experiment.groups) {
    truths.push_back(commandOf(experiment.shots[group.shot], truthShotOf(experiment, group)));
    points[truths.back()] += group.arms.size();
  }
  // The largest first, each to the share with the fewest points; equal ones in the order of the hash.
  std::vector<std::tuple<size_t, std::string, std::string>> order;
  for (const auto& [truth, count] : points) order.emplace_back(count, hashText(truth), truth);
  std::sort(order.rbegin(), order.rend());
  std::vector<size_t> loads(of), result;
  std::map<std::string, size_t> share_of;
  for (const auto& [count, hash, truth] : order) {
    auto least = std::min_element(loads.begin(), loads.end());
    *least += count;
    share_of[truth] = size_t(least - loads.begin()) + 1;
  }
  for (const std::string& truth : truths) result.push_back(share_of[truth]);
  return result;
}

size_t countTruths(const std::set<std::string>& commands) { return commands.size() - commands.count(""); }

script::Settings joined(script::Settings base, const script::Settings& more) {
  base.insert(base.end(), more.begin(), more.end());
  return base;
}

std::string commandOf(const StudiedShot& studied, const lab::Shot& shot) {
  std::string command = lab::commandOf(shot);
  size_t at = studied.shared.empty() ? std::string::npos : command.find(shot.scene);
  return at == std::string::npos ? command : command.replace(at, shot.scene.size(), "$STROBE_DATA/" + studied.shared);
}

// Shot with the settings that all pictures of a group share.
static lab::Shot bareShot(const Experiment& experiment, const Group& group) {
  const StudiedShot& studied = experiment.shots[group.shot];
  lab::Shot shot = studied.shot;
  if (shot.width == 0) shot.width = experiment.width, shot.height = experiment.height;
  shot.sets.clear();
  size_t sized = lab::isGltf(shot.scene) ? 0 : std::min<size_t>(experiment.size_params.size(), 2);
  for (size_t i = 0; i < sized; ++i)
    shot.sets.emplace_back("scene." + experiment.size_params[i], int64_t(i == 0 ? shot.width : shot.height));
  shot.sets = joined(shot.sets, studied.shot.sets);
  for (const At& at : group.at) {
    const AxisValue& value = experiment.axes[at.axis].settings[at.value];
    lab::setOptions(shot, value.options);
    for (const auto& [name, set] : value.scene) lab::putSetting(shot.sets, name, set);
  }
  return shot;
}

lab::Shot shotOf(const Experiment& experiment, const Group& group, const StudiedArm& arm) {
  lab::Shot shot = bareShot(experiment, group);
  shot.pipeline = arm.pipeline;
  shot.sets = joined(shot.sets, arm.sets);
  auto lacks = [&arm](const std::string& name) { return contains(arm.lacks, name); };
  for (const At& at : group.at)
    for (const auto& [name, value] : experiment.axes[at.axis].settings[at.value].sets)
      if (!lacks(name) && !lacks(experiment.axes[at.axis].name)) lab::putSetting(shot.sets, name, value);
  return shot;
}

lab::Shot truthShotOf(const Experiment& experiment, const Group& group, const script::Settings& more) {
  lab::Shot shot = bareShot(experiment, group);
  shot.pipeline = experiment.truth.pipeline;
  shot.sets = joined(shot.sets, experiment.truth.sets);
  auto put = [&shot](const script::Settings& sets) {
    for (const auto& [name, value] : sets) lab::putSetting(shot.sets, name, value);
  };
  put(experiment.shots[group.shot].truth);
  for (const At& at : group.at) put(experiment.axes[at.axis].settings[at.value].truth);
  put(more);
  return shot;
}

std::vector<lab::Shot> sequenceOf(const StudiedShot& studied, const lab::Shot& shot) {
  if (studied.frames.empty()) return {shot};
  std::vector<lab::Shot> sequence;
  for (int frame : studied.frames) {
    lab::Shot& one = sequence.emplace_back(shot);
    if (one.rest_frame < 0) one.rest_frame = studied.frames.front();
    one.frame = frame;
  }
  return sequence;
}

void addInput(Inputs& inputs, const Home& home, const Path& file) {
  if (!std::filesystem::is_regular_file(file)) return;
  auto [input, is_new] = inputs.try_emplace(home.recorded(file, file.string()));
  if (is_new) input->second = inputHash(file);
}

void nameInputs(Inputs& inputs, const Home& home) {
  Inputs named;
  for (const auto& [name, hash] : inputs) named[Path(name).is_absolute() ? home.recorded(name, name) : name] = hash;
  inputs = std::move(named);
}

Experiment readExperiment(const Home& home, const std::string& file, bool evaluate) {
  std::vector<script::Dependency> dependencies;
  Json json = script::evaluateData(home, file, given(), &dependencies, kLimits);
  if (!json.is_object() || json.value("kind", "") != "experiment")
    throw Error("does not return experiment { ... } of strobe.experiment, or capture { ... } with `measures`", {file});
  Experiment experiment;
  try {
    experiment = experimentOf(home, json, file);
  } catch (const Json::exception& error) {
    throw Error(fmt::format("a value of the experiment has a wrong form: {}", error.what()), {file});
  }
  experiment.file = file;
  for (const script::Dependency& one : dependencies) addInput(experiment.inputs, home, one.path);
  check(home, experiment, file, evaluate);
  return experiment;
}

Json judge(const Home& home, const std::string& file, const Json& results) {
  Json arguments = given();
  arguments["results"] = results;
  return script::evaluateData(home, file, arguments, nullptr, kLimits);
}

}  // namespace strobe::study
