// SPDX-License-Identifier: MIT
#include "stability/curves_experiment.h"

#include <algorithm>
#include <set>

#include "lab/demo.h"
#include "lab/shot_options.h"
#include "lab/workbench.h"

namespace strobe::stability::curves {

namespace {

template <class Value>
void take(const Json& from, const char* name, Value& into) {
  if (from.contains(name)) into = from.at(name).get<Value>();
}

Method methodOf(const Json& json) {
  Method method;
  take(json, "label", method.label);
  take(json, "pipeline", method.pipeline);
  take(json, "lacks", method.lacks);
  method.sets = lab::settingsOf(json, "set");
  return method;
}

AxisPoint pointOf(const Json& json) {
  AxisPoint point;
  take(json, "value", point.value);
  take(json, "label", point.label);
  point.scene = lab::settingsOf(json, "scene");
  for (auto& set : point.scene) set.first = "scene." + set.first;
  point.pipeline = lab::settingsOf(json, "set");
  point.truth = lab::settingsOf(json, "truth");
  point.floor = lab::settingsOf(json, "floor");
  point.shot = lab::settingsOf(json, "shot");
  return point;
}

Axis axisOf(const Json& json) {
  Axis axis;
  take(json, "name", axis.name);
  take(json, "title", axis.title);
  take(json, "unit", axis.unit);
  take(json, "scale", axis.scale);
  take(json, "region", axis.region);
  take(json, "scene", axis.scene);
  take(json, "fixed", axis.fixed);
  take(json, "note", axis.note);
  take(json, "reading", axis.reading);
  take(json, "benign", axis.benign);
  take(json, "same_picture", axis.same_picture);
  for (const Json& point : json.at("points")) axis.points.push_back(pointOf(point));
  return axis;
}

Variant variantOf(const Json& json) {
  Variant variant;
  take(json, "name", variant.name);
  take(json, "title", variant.title);
  take(json, "reference", variant.reference);
  take(json, "reading", variant.reading);
  take(json, "values", variant.values);
  return variant;
}

Case caseOf(const Json& json) {
  Case in;
  take(json, "label", in.label);
  take(json, "scene", in.scene);
  in.sets = lab::settingsOf(json, "set");
  for (auto& set : in.sets) set.first = "scene." + set.first;
  return in;
}

Experiment experimentOf(const Json& json) {
  Experiment experiment;
  take(json, "title", experiment.title);
  take(json, "note", experiment.note);
  take(json, "factor", experiment.factor);
  take(json, "size_params", experiment.size_params);
  std::array<int, 2> size = {experiment.width, experiment.height};
  take(json, "size", size);
  experiment.width = size[0], experiment.height = size[1];
  experiment.truth = methodOf(json.at("truth"));
  experiment.floor = methodOf(json.at("floor"));
  for (const Json& method : json.at("methods")) experiment.methods.push_back(methodOf(method));
  for (const Json& axis : json.at("axes")) experiment.axes.push_back(axisOf(axis));
  if (!json.contains("variants")) return experiment;
  for (const Json& variant : json.at("variants")) experiment.variants.push_back(variantOf(variant));
  for (const Json& in : json.at("cases")) experiment.cases.push_back(caseOf(in));
  return experiment;
}

void setOption(lab::Shot& shot, const std::string& name, const plan::Value& value) {
  std::vector<std::string> names;
  for (const lab::ShotOption& option : lab::shotOptions())
    for (const lab::ShotField& field : option.fields) {
      if (!field.isValue()) continue;
      if (field.declaration.name == name) return field.set(shot, value);
      names.push_back(field.declaration.name);
    }
  throw Error(fmt::format("a shot has no option '{}'{}", name, didYouMean(name, names)));
}

template <class Step>
void collect(std::vector<std::string>& problems, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    if (std::find(problems.begin(), problems.end(), error.what()) == problems.end()) problems.push_back(error.what());
  }
}

// Every method knows the variants; the first one that does knows every value.
void checkVariants(const Home& home, const Experiment& experiment, std::vector<std::string>& problems) {
  auto evaluate = [&](const lab::Shot& shot) {
    collect(problems, [&] { script::evaluatePipeline(home, {shot.pipeline, shot.sets}); });
  };
  std::set<std::string> known;
  for (const Method& method : experiment.methods) {
    if (experiment.variants.empty()) return;
    lab::Shot shot = shotOf(experiment, experiment.cases.front(), method);
    for (const Variant& variant : experiment.variants) {
      if (lacks(method, variant.name)) continue;
      lab::putSetting(shot.sets, variant.name, plan::valueFromText(variant.reference));
      if (!known.insert(variant.name).second) continue;
      for (const std::string& value : variant.values)
        evaluate(shotOf(experiment, experiment.cases.front(), method, variant.name, value));
    }
    evaluate(shot);
  }
}

// Of each axis the benign point alone: names are the same at all of them.
void check(const Home& home, const Experiment& experiment, const std::string& file) {
  std::vector<std::string> problems;
  bool fits =
      experiment.width >= 1 && experiment.height >= 1 && experiment.width <= 16384 && experiment.height <= 16384;
  if (!fits) problems.push_back(Error("size is not 1 to 16384 pixels", {file}).what());
  std::vector<const Method*> all = {&experiment.truth, &experiment.floor};
  for (const Method& method : experiment.methods) all.push_back(&method);
  for (const Axis& axis : experiment.axes) {
    const AxisPoint& point = axis.points[axis.benignIndex()];
    bool first = &axis == &experiment.axes.front();
    for (const Method* method : all) {
      bool same = !first && point.pipeline.empty() && point.truth.empty() && point.floor.empty();
      if (!same)
        collect(problems, [&] {
          lab::Shot shot = shotOf(experiment, axis, point, *method);
          script::evaluatePipeline(home, {shot.pipeline, shot.sets});
        });
    }
    collect(problems, [&] {
      lab::Shot shot = shotOf(experiment, axis, point, experiment.truth);
      lab::loadScene(home, shot);
    });
  }
  checkVariants(home, experiment, problems);
  for (const Case& in : experiment.cases)
    collect(problems, [&] {
      lab::Shot shot = shotOf(experiment, in, experiment.truth);
      lab::loadScene(home, shot);
    });
  throwIfAny(problems);
}

}  // namespace

bool lacks(const Method& method, const std::string& setting) {
  return std::find(method.lacks.begin(), method.lacks.end(), setting) != method.lacks.end();
}

size_t Axis::benignIndex() const {
  auto found =
      std::find_if(points.begin(), points.end(), [&](const AxisPoint& point) { return point.value == benign; });
  STROBE_ASSERT(found != points.end(), "axis '{}'", name);
  return size_t(found - points.begin());
}

void Experiment::keepOnly(const std::string& name) {
  std::vector<std::string> names;
  for (const Axis& axis : axes) names.push_back(axis.name);
  if (!variants.empty()) names.push_back("variants");
  std::erase_if(axes, [&](const Axis& axis) { return axis.name != name; });
  if (name != "variants") variants.clear(), cases.clear();
  if (axes.empty() && variants.empty())
    throw Error(
        fmt::format("--only '{}' is no axis{}; there are {}", name, didYouMean(name, names), fmt::join(names, ", ")),
        {}, 2);
}

void Experiment::setTruthSamples(int samples) {
  lab::putSetting(truth.sets, "samples", int64_t(samples));
  for (Axis& axis : axes)
    for (AxisPoint& point : axis.points)
      std::erase_if(point.truth, [](const auto& set) { return set.first == "samples"; });
}

void retell(Report& report, const Experiment& experiment) {
  report.title = experiment.title;
  report.note = experiment.note;
  report.truth = experiment.truth.label, report.floor = experiment.floor.label;
  for (ReportAxis& told : report.axes)
    for (const Axis& axis : experiment.axes)
      if (axis.name == told.name)
        told.title = axis.title, told.unit = axis.unit, told.scale = axis.scale, told.region = axis.region,
        told.fixed = axis.fixed, told.note = axis.note, told.reading = axis.reading;
  for (ReportVariant& told : report.variants)
    for (const Variant& variant : experiment.variants)
      if (variant.name == told.name) told.title = variant.title, told.reading = variant.reading;
}

// What every picture of the experiment has.
static lab::Shot bareShot(const Experiment& experiment, const std::string& scene, const Method& method) {
  lab::Shot shot;
  shot.scene = scene;
  shot.pipeline = method.pipeline;
  shot.width = experiment.width;
  shot.height = experiment.height;
  for (size_t i = 0; i < experiment.size_params.size() && i < 2; ++i)
    shot.sets.emplace_back("scene." + experiment.size_params[i], int64_t(i == 0 ? shot.width : shot.height));
  return shot;
}

lab::Shot shotOf(const Experiment& experiment, const Axis& axis, const AxisPoint& point, const Method& method) {
  lab::Shot shot = bareShot(experiment, axis.scene, method);
  for (const auto& [name, value] : point.shot) setOption(shot, name, value);
  shot.sets = lab::joined(lab::joined(shot.sets, point.scene), method.sets);
  auto put = [&shot](const script::Settings& sets) {
    for (const auto& [name, value] : sets) lab::putSetting(shot.sets, name, value);
  };
  bool is_truth = &method == &experiment.truth, is_floor = &method == &experiment.floor;
  if (is_truth) put(point.truth);
  if (is_floor) put(point.floor);
  if (is_truth || is_floor) return shot;
  for (const auto& set : point.pipeline)
    if (!lacks(method, set.first)) put({set});
  return shot;
}

lab::Shot shotOf(const Experiment& experiment, const Case& in, const Method& method, const std::string& name,
                 const std::string& value) {
  lab::Shot shot = bareShot(experiment, in.scene, method);
  shot.sets = lab::joined(lab::joined(shot.sets, in.sets), method.sets);
  if (!name.empty()) lab::putSetting(shot.sets, name, plan::valueFromText(value));
  return shot;
}

Experiment readExperiment(const Home& home, const std::string& file) {
  Json json = script::evaluateData(home, file);
  if (!json.is_object() || !json.contains("kind") || json["kind"] != "extremes")
    throw Error("does not return extremes { ... } of strobe.extremes", {file});
  Experiment experiment;
  try {
    experiment = experimentOf(json);
  } catch (const Json::exception& error) {
    throw Error(fmt::format("a value of the experiment has a wrong form: {}", error.what()), {file});
  }
  check(home, experiment, file);
  return experiment;
}

}  // namespace strobe::stability::curves
