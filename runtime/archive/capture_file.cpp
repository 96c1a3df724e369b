// SPDX-License-Identifier: MIT
#include "archive/capture_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/home.h"
#include "base/lists.h"
#include "lab/shot_options.h"
#include "plan/named.h"

namespace strobe::archive {

namespace {

std::optional<Layers> layersFrom(const Json& json) {
  if (!json.contains("layers")) return {};
  if (json["layers"].is_string()) return Layers{true, {}};
  return Layers{false, json["layers"].get<std::vector<std::string>>()};
}

std::vector<SequenceStep> stepsFrom(const Json& json) {
  std::vector<SequenceStep> steps;
  for (int frame : lab::framesFrom(json))
    steps.push_back({fmt::format("frame {}", frame), Json::array({{{"name", "frame"}, {"value", frame}}}), {}});
  for (const Json& one : json.value("steps", Json::array())) {
    script::Settings sets = lab::settingsFrom(one, "scene_set", "scene.");
    for (const script::Setting& set : lab::settingsFrom(one, "set")) sets.push_back(set);
    steps.push_back({one.at("label").get<std::string>(), one.at("options"), std::move(sets)});
  }
  if (steps.empty()) steps.emplace_back();
  return steps;
}

CapturedShot shotFrom(const Home& home, const Json& json, const Path& script, uint32_t seed) {
  CapturedShot result;
  result.name = json.at("name").get<std::string>();
  result.title = json.value("title", result.name);
  result.attribution = json.value("attribution", "");
  result.tone = lab::toneFrom(json);
  result.shot.seed = seed;
  lab::setOptions(result.shot, json.at("options"));
  result.shot.sets = lab::settingsFrom(json, "scene_set", "scene.");
  result.truth = lab::settingsFrom(json, "truth");
  result.steps = stepsFrom(json);
  // Nodes that options move are at rest at the first frame.
  std::vector<int> frames = lab::framesFrom(json);
  if (!frames.empty() && result.shot.rest_frame < 0) result.shot.rest_frame = frames.front();
  result.scene_name = result.shot.scene;
  lab::SceneFile scene = lab::sceneFile(home, lab::besideScript(script, result.shot.scene));
  result.shot.scene = scene.scene, result.missing = scene.missing;
  return result;
}

CapturedArm armFrom(const Json& json, const Path& script) {
  CapturedArm arm{lab::armFrom(json, script)};
  arm.shots = json.value("shots", std::vector<std::string>{});
  arm.layers = layersFrom(json);
  if (!json.contains("files")) return arm;
  const Path here = std::filesystem::absolute(script).lexically_normal().parent_path();
  const std::string files = json["files"].get<std::string>();
  arm.files = (here / files / "").lexically_normal().parent_path();
  bool inside = std::filesystem::is_directory(arm.files) && liesIn(arm.files, here);
  if (!inside) throw Error(fmt::format("arm '{}': '{}' is not a folder beside the script", arm.name, files), {script});
  return arm;
}

// Throws `Error` if two names give the same file name.
template <class Named>
void refuseSameFiles(const std::vector<Named>& list, const char* what, const std::string& script) {
  std::map<std::string, std::string> names;
  for (const Named& one : list) {
    auto [known, fresh] = names.emplace(lab::fileNameOf(one.name), one.name);
    if (!fresh)
      throw Error(fmt::format("{}s '{}' and '{}' would write the same files, '{}'", what, known->second, one.name,
                              known->first),
                  {script});
  }
}

template <class Named>
const Named& named(const std::vector<Named>& list, const std::string& name, const char* what) {
  if (const Named* found = plan::find(list, name)) return *found;
  throw Error(fmt::format("the capture has no {} '{}'{}", what, name, didYouMean(name, plan::namesOf(list))));
}

}  // namespace

bool CapturedArm::draws(const std::string& shot) const { return shots.empty() || contains(shots, shot); }

const CapturedShot& CaptureFile::shot(const std::string& name) const { return named(shots, name, "shot"); }
const CapturedArm& CaptureFile::arm(const std::string& name) const { return named(arms, name, "arm"); }

CaptureFile readCapture(const Home& home, const std::string& file, std::array<int, 2> size) {
  CaptureFile capture;
  capture.file = file;
  Json json = script::evaluateData(home, file, {{"options", lab::shotOptionsJson()}}, &capture.scripts);
  if (json.is_object() && json.value("kind", "") == "experiment")
    throw Error("is an experiment, not a capture { ... }: run it with `strobe sweep`", {file});
  if (!json.is_object() || json.value("kind", "") != "capture") throw Error("does not return capture { ... }", {file});
  capture.title = json.at("title").get<std::string>();
  capture.note = json.value("note", ""), capture.truth = json.value("truth", "");
  capture.measured = json.contains("measures");
  capture.most_flip = json.value("most_flip", capture.most_flip);
  std::array<int, 2> own = json.value("size", std::array<int, 2>{480, 270});
  capture.file_width = own[0], capture.file_height = own[1];
  if (size[0] == 0) size = own;
  capture.width = size[0], capture.height = size[1];
  if (std::min(size[0], size[1]) < 1 || std::max(size[0], size[1]) > plan::kMaxSide)
    throw Error(fmt::format("size must be 1 to {} pixels", plan::kMaxSide), {file});
  for (const Json& shot : json.at("shots")) capture.shots.push_back(shotFrom(home, shot, file, json.value("seed", 0u)));
  for (const Json& arm : json.at("arms")) capture.arms.push_back(armFrom(arm, file));
  refuseSameFiles(capture.shots, "shot", file);
  refuseSameFiles(capture.arms, "arm", file);
  capture.layers = layersFrom(json);
  for (auto [kind, list] : {std::pair("figures", &capture.figures), std::pair("films", &capture.films)})
    for (Json one : json.value(kind, Json::array())) {
      one["size"] = own;
      if (size != own) one["drawn"] = size;
      list->push_back(std::move(one));
    }
  return capture;
}

lab::Shot shotOf(const CaptureFile& capture, const CapturedShot& captured, const CapturedArm& arm, size_t step) {
  lab::Shot shot = captured.shot;
  auto scaled = [](int own, int size, int of_file) {
    return std::max(1, int(std::lround(double(own) * size / of_file)));
  };
  bool has_size = shot.width > 0;  // the shot's own size, scaled with the capture's
  shot.width = has_size ? scaled(shot.width, capture.width, capture.file_width) : capture.width;
  shot.height = has_size ? scaled(shot.height, capture.height, capture.file_height) : capture.height;
  shot.pipeline = arm.pipeline;
  shot.sets.insert(shot.sets.end(), arm.sets.begin(), arm.sets.end());
  if (arm.name == capture.truth)
    for (const auto& [name, value] : captured.truth) lab::putSetting(shot.sets, name, value);
  const SequenceStep& at = captured.steps.at(step);
  lab::setOptions(shot, at.options);
  for (const auto& [name, value] : at.sets) lab::putSetting(shot.sets, name, value);
  return shot;
}

Layers layersOf(const CaptureFile& capture, const CapturedShot& shot, const CapturedArm& arm) {
  if (arm.layers) return *arm.layers;
  if (capture.layers) return *capture.layers;
  return {!shot.isSequence(), {}};
}

}  // namespace strobe::archive
