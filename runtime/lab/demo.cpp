// SPDX-License-Identifier: MIT
#include "lab/demo.h"

#include <algorithm>
#include <filesystem>

#include "lab/workbench.h"

namespace strobe::lab {

namespace {

template <class Value>
void take(const Json& from, const char* name, Value& into) {
  if (from.contains(name)) into = from.at(name).get<Value>();
}

DemoColumn columnOf(const Json& json) {
  DemoColumn column;
  take(json, "label", column.label);
  take(json, "pipeline", column.pipeline);
  take(json, "own_anchor", column.own_anchor);
  take(json, "shown", column.shown);
  column.sets = settingsOf(json, "set");
  column.warm = settingsOf(json, "warm");
  column.box = settingsOf(json, "box");
  std::string role = "method";
  take(json, "role", role);
  if (role == "truth") column.role = DemoColumn::Role::truth;
  if (role == "floor") column.role = DemoColumn::Role::floor;
  return column;
}

DemoCrop cropOf(const Json& json) {
  if (json.is_string()) return std::nullopt;
  std::array<double, 4> n = json.get<std::array<double, 4>>();
  return image::Rectangle{int(n[0]), int(n[1]), int(n[2]), int(n[3])};
}

// "shared:x" is a file of the shared data.
void resolveScene(const Home& home, DemoShot& shot) {
  const std::string prefix = "shared:";
  if (!shot.shot.scene.starts_with(prefix)) return;
  std::string name = shot.shot.scene.substr(prefix.size());
  std::optional<Path> data = home.data();
  if (!data) shot.missing = "there is no shared data (STROBE_DATA names its folder)";
  else if (!std::filesystem::exists(*data / name)) shot.missing = fmt::format("the shared data has no '{}'", name);
  else shot.shot.scene = (*data / name).string();
}

DemoShot shotOf(const Home& home, const Json& json, const Demo& demo) {
  DemoShot result;
  Shot& shot = result.shot;
  take(json, "title", result.title);
  take(json, "note", result.note);
  take(json, "attribution", result.attribution);
  take(json, "scene", shot.scene);
  take(json, "camera", shot.camera);
  take(json, "animation", shot.animation);
  take(json, "anchor", shot.anchor);
  take(json, "fps", shot.fps);
  take(json, "exposure", shot.exposure);
  double frame = shot.frame, aa = 1, stops = 0;
  take(json, "frame", frame);
  take(json, "picture_aa", aa);
  take(json, "stops", stops);
  shot.frame = int(frame);
  shot.aa = int(aa);
  take(json, "moves", shot.moves);
  take(json, "spins", shot.spins);
  shot.sets = settingsOf(json, "scene_set");
  for (auto& set : shot.sets) set.first = "scene." + set.first;
  shot.seed = demo.seed;
  shot.width = demo.width;
  shot.height = demo.height;
  result.truth = settingsOf(json, "truth");
  if (json.contains("full_shading")) result.full_shading = settingsOf(json, "full_shading");
  std::string curve = "clamp";
  take(json, "curve", curve);
  result.tone.stops = float(stops);
  if (curve == "filmic") result.tone.curve = image::ToneMap::Curve::filmic;
  if (json.contains("crops"))
    for (const Json& crop : json.at("crops")) result.crops.push_back(cropOf(crop));
  else result.crops.push_back(std::nullopt);
  resolveScene(home, result);
  return result;
}

DemoBackground backgroundOf(const Json& json) {
  return {json.at("column"), json.at("color"), json.at("valid"), json.at("front")};
}

DemoExpectation expectationOf(const Json& json) {
  DemoExpectation expectation;
  take(json, "column", expectation.column);
  take(json, "region", expectation.region);
  take(json, "baselines", expectation.baselines);
  take(json, "share", expectation.share);
  take(json, "floor", expectation.floor);
  take(json, "contrast", expectation.contrast);
  return expectation;
}

Demo demoOf(const Home& home, const Json& json) {
  Demo demo;
  take(json, "title", demo.title);
  take(json, "note", demo.note);
  take(json, "difference_gain", demo.difference_gain);
  std::array<double, 2> size = {960, 540}, crop = {120, 68};
  double seed = 0;
  take(json, "size", size);
  take(json, "crop_size", crop);
  take(json, "seed", seed);
  demo.width = int(size[0]), demo.height = int(size[1]);
  demo.crop_width = int(crop[0]), demo.crop_height = int(crop[1]);
  demo.seed = uint32_t(seed);
  demo.regions = {"whole", "inner", "hidden", "outer"};
  demo.measures = {"rmse", "flip", "ms"};
  take(json, "regions", demo.regions);
  take(json, "measures", demo.measures);
  for (const Json& column : json.at("columns")) demo.columns.push_back(columnOf(column));
  for (const Json& shot : json.at("shots")) demo.shots.push_back(shotOf(home, shot, demo));
  if (json.contains("background")) demo.background = backgroundOf(json.at("background"));
  if (json.contains("expectation")) demo.expectation = expectationOf(json.at("expectation"));
  return demo;
}

template <class Step>
void collect(std::vector<std::string>& problems, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    if (std::find(problems.begin(), problems.end(), error.what()) == problems.end()) problems.push_back(error.what());
  }
}

void checkDemo(const Home& home, const Demo& demo, const std::string& file) {
  std::vector<std::string> problems;
  auto refuse = [&](const std::string& text) { problems.push_back(Error(text, {file}).what()); };
  if (demo.width < 1 || demo.height < 1 || demo.width > 16384 || demo.height > 16384)
    refuse("size is not 1 to 16384 pixels");
  if (demo.crop_width < 1 || demo.crop_height < 1) refuse("crop_size is not at least 1 pixel");
  if (!(demo.difference_gain > 0)) refuse("difference_gain is not above 0");
  auto known = [&](const std::string& region) {
    return std::find(demo.regions.begin(), demo.regions.end(), region) != demo.regions.end();
  };
  if (demo.expectation && !known(demo.expectation->region))
    refuse(fmt::format("the expectation's region '{}' is not among the regions", demo.expectation->region));
  auto evaluate = [&](const DemoColumn& column, const script::Settings& more) {
    collect(problems, [&] { script::evaluatePipeline(home, {column.pipeline, joined(column.sets, more)}); });
  };
  for (const DemoColumn& column : demo.columns)
    for (const script::Settings& more : {script::Settings(), column.warm, column.box}) evaluate(column, more);
  for (const DemoShot& shot : demo.shots) {
    evaluate(demo.truth(), shot.truth);
    if (shot.full_shading) evaluate(demo.truth(), *shot.full_shading);
    if (!shot.missing.empty()) continue;
    Shot copy = shot.shot;
    collect(problems, [&] { loadScene(home, copy); });
  }
  throwIfAny(problems);
}

}  // namespace

const DemoColumn& Demo::truth() const {
  auto is_truth = [](const DemoColumn& column) { return column.role == DemoColumn::Role::truth; };
  auto found = std::find_if(columns.begin(), columns.end(), is_truth);
  STROBE_ASSERT(found != columns.end());
  return *found;
}

script::Settings joined(script::Settings base, const script::Settings& more) {
  base.insert(base.end(), more.begin(), more.end());
  return base;
}

// An empty table of Lua is an empty list.
script::Settings settingsOf(const Json& from, const char* name) {
  script::Settings sets;
  if (!from.contains(name)) return sets;
  for (const Json& one : from.at(name))
    sets.emplace_back(one.at("name").get<std::string>(), plan::valueFromText(one.at("value").get<std::string>()));
  return sets;
}

std::string fileNameOf(const std::string& label) {
  std::string name;
  for (unsigned char c : label) {
    if (std::isalnum(c)) name += char(std::tolower(c));
    else if (!name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "unnamed" : name;
}

Demo readDemo(const Home& home, const std::string& file) {
  std::vector<script::Dependency> dependencies;
  Json json = script::evaluateData(home, file, {}, &dependencies);
  if (!json.is_object() || !json.contains("kind") || json["kind"] != "demo")
    throw Error("does not return a demo { ... } of strobe.demo", {file});
  Demo demo;
  int truths = 0;
  try {
    demo = demoOf(home, json);
  } catch (const Json::exception& error) {
    throw Error(fmt::format("a value of the demo has a wrong form: {}", error.what()), {file});
  }
  demo.dependencies = dependencies;
  for (const DemoColumn& column : demo.columns) truths += column.role == DemoColumn::Role::truth;
  if (truths != 1) throw Error("not exactly one column is the truth", {file});
  checkDemo(home, demo, file);
  return demo;
}

}  // namespace strobe::lab
