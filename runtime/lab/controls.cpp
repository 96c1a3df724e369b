// SPDX-License-Identifier: MIT
#include "lab/controls.h"

#include <algorithm>

#include "plan/named.h"
#include "plan/settings.h"

namespace strobe::lab {

plan::ParamDesc declarationOf(const ShotField& field, const scene::Scene& scene) {
  plan::ParamDesc declared = field.declaration;
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

// Presets as one choice parameter.
static plan::ParamDesc declarationOf(const std::vector<plan::PresetDesc>& presets) {
  plan::ParamDesc declared;
  declared.name = plan::kPresetSetting;
  declared.type = plan::ParamDesc::Type::Choice;
  declared.doc = "named set of values; single settings override its values";
  for (const plan::PresetDesc& preset : presets) {
    declared.choices.push_back(preset.name);
    declared.values.emplace_back(preset.name, preset.doc);
    if (preset.is_default) declared.default_value = preset.name;
  }
  return declared;
}

namespace {

class Collector {
 public:
  explicit Collector(const std::map<std::string, std::string>& origins) : origins_(origins) {}

  // `otherwise`: origin of a value that was not set.
  void add(plan::ParamDesc declaration, const plan::Value& value, const std::string& group, const std::string& place,
           const std::string& otherwise) {
    auto set = origins_.find(declaration.name);
    bool is_set = set != origins_.end();
    controls.push_back({std::move(declaration), value, group, is_set ? set->second : otherwise, place, is_set});
  }

  std::vector<Control> controls;

 private:
  const std::map<std::string, std::string>& origins_;
};

void addShot(Collector& into, const Shot& shot, const scene::Scene& scene, const std::string& given_by) {
  Shot defaults;
  for (const ShotOption& option : shotOptions()) {
    if (!option.is(ShotOption::kControl)) continue;
    for (const ShotField& field : option.fields) {
      plan::ParamDesc declaration = declarationOf(field, scene);
      plan::Value value = field.get(shot);
      bool is_default = value == field.get(defaults);
      bool first_camera = declaration.name == "camera" && shot.camera.empty() && !declaration.choices.empty();
      if (first_camera) value = scene.nodes[size_t(scene::cameraNode(scene, ""))].name;
      into.add(declaration, value, "shot", "", is_default ? "default" : given_by + " or scene");
    }
  }
}

// Names of the nodes that follow a pipeline parameter; `in_plan`: nodes in the plan, otherwise nodes not in the plan.
std::vector<std::string> followers(const plan::Plan& plan, const std::string& param, bool in_plan) {
  std::vector<std::string> names;
  for (size_t i = 0; i < plan.pipeline.nodes.size(); ++i) {
    const plan::NodeDesc& node = plan.pipeline.nodes[i];
    bool planned = std::any_of(plan.nodes.begin(), plan.nodes.end(),
                               [&](const plan::PlanNode& one) { return size_t(one.node) == i; });
    bool follows = std::any_of(node.params.begin(), node.params.end(),
                               [&](const auto& bound) { return bound.second.follows == param; });
    if (follows && planned == in_plan) names.push_back(node.name);
  }
  return names;
}

std::string idleReason(const plan::Plan& plan, const std::string& param) {
  if (plan::decidesGraph(plan.pipeline, param) || !followers(plan, param, true).empty()) return "";
  std::vector<std::string> left_out = followers(plan, param, false);
  if (left_out.empty()) return "no pass reads it with the present values of the other parameters";
  return fmt::format("only {} reads it, which does not run in this frame", fmt::join(left_out, ", "));
}

void addPipeline(Collector& into, const plan::Plan& plan) {
  const plan::PipelineDesc& pipeline = plan.pipeline;
  if (!pipeline.presets.empty())
    into.add(declarationOf(pipeline.presets), pipeline.preset, "pipeline", pipeline.file, "default");
  for (const plan::ParamDesc& declared : pipeline.params) {
    const plan::Value& value = *plan::valueOf(pipeline, declared.name);
    bool by_preset = !pipeline.preset.empty() && !(value == declared.default_value);
    into.add(declared, value, "pipeline", declared.place.text(), by_preset ? "preset " + pipeline.preset : "default");
    into.controls.back().idle = idleReason(plan, declared.name);
  }
}

void addNode(Collector& into, const plan::Plan& plan, const plan::PlanNode& node) {
  const plan::NodeDesc& described = plan.descOf(node);
  const std::vector<plan::ParamDesc>& params = plan.passOf(node).params;
  for (size_t i = 0; i < params.size(); ++i) {
    if (params[i].wired) continue;
    plan::ParamDesc declaration = params[i];
    declaration.name = described.name + "." + params[i].name;
    const plan::Binding* bound = plan::valueIn(described.params, params[i].name);
    const plan::Value& value = node.params[i].second;
    into.add(declaration, value, described.name, params[i].place.text(),
             bound && !bound->follows.empty()   ? "follows " + bound->follows
             : value == params[i].default_value ? "default"
                                                : plan.pipeline.file);
  }
}

}  // namespace

std::vector<Control> controlsOf(const Shot& shot, const Drawing& drawing,
                                const std::map<std::string, std::string>& origins, const std::string& given_by) {
  Collector collector(origins);
  const plan::Plan& plan = drawing.plan();
  addShot(collector, shot, drawing.scene().scene, given_by);
  addPipeline(collector, plan);
  for (const plan::PlanNode& node : plan.nodes) addNode(collector, plan, node);
  return std::move(collector.controls);
}

}  // namespace strobe::lab
