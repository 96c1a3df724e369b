// SPDX-License-Identifier: MIT
#include "stability/variants.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "plan/canonical.h"
#include "plan/named.h"

namespace strobe::stability {

using plan::ParamDesc;
using plan::PassDesc;
using plan::PipelineDesc;
using plan::textOf;

bool Variant::isBase() const {
  return sets.empty() || (sets.size() == 1 && sets.front().first == plan::kPresetSetting);
}

std::string Variant::name() const {
  std::string text;
  for (const auto& [name, value] : sets) text += (text.empty() ? "" : " ") + name + "=" + textOf(value);
  return text.empty() ? "defaults" : text;
}

std::string Variant::method() const { return sets.empty() ? pipeline : pipeline + " " + name(); }

static const PassDesc& passOf(const PipelineDesc& pipeline, const plan::NodeDesc& node) {
  return *plan::find(pipeline.passes, node.pass);
}

// ---- the walk

// Values to try: all values of switches and choices; for numbers that are compiled in, the bounds and the default.
static std::vector<std::string> valuesOf(const ParamDesc& param) {
  if (param.type == ParamDesc::Type::Bool) return {"false", "true"};
  if (param.type == ParamDesc::Type::Choice) return param.choices;
  std::set<std::string> values = {textOf(param.default_value)};
  for (const auto& bound : {param.min, param.max})
    if (bound) values.insert(fmt::format("{}", *bound));
  return {values.begin(), values.end()};
}

// A value to try.
struct Try {
  std::string name, value;
};

static std::vector<Try> triesOf(const std::string& name, const ParamDesc& param, const plan::Value& now) {
  std::vector<Try> tries;
  if (!plan::isCompiledIn(param) || param.wired) return tries;
  for (const std::string& value : valuesOf(param))
    if (value != textOf(now)) tries.push_back({name, value});
  return tries;
}

// "node pass": a node with another pass is another node.
static std::set<std::string> nodesOf(const PipelineDesc& pipeline) {
  std::set<std::string> names;
  for (const auto& node : pipeline.nodes) names.insert(node.name + " " + node.pass);
  return names;
}

// Values to try for the parameters of the pipeline and of its nodes; only for parameters of nodes that are not `known`.
static std::vector<Try> triesIn(const PipelineDesc& pipeline, const std::set<std::string>& known) {
  std::vector<Try> tries;
  auto add = [&tries](const std::vector<Try>& more) { tries.insert(tries.end(), more.begin(), more.end()); };
  std::set<std::string> follow;  // parameters of the pipeline that nodes outside `known` follow
  for (const auto& node : pipeline.nodes) {
    if (known.count(node.name + " " + node.pass)) continue;
    const PassDesc& pass = passOf(pipeline, node);
    for (const auto& [name, binding] : node.params) {
      if (!binding.follows.empty()) follow.insert(binding.follows);
      const ParamDesc& param = *plan::find(pass.params, name);
      if (binding.follows.empty()) add(triesOf(node.name + "." + name, param, *binding.value));
    }
  }
  for (const ParamDesc& param : pipeline.params)
    if (known.empty() || follow.count(param.name))
      add(triesOf(param.name, param, *plan::valueOf(pipeline, param.name)));
  return tries;
}

namespace {

class Walker {
 public:
  Walker(lab::Batch& batch, const std::string& pipeline) : batch_(batch), pipeline_(pipeline) {}

  VariantList run() {
    std::vector<script::Settings> bases;
    const std::shared_ptr<const PipelineDesc> plain = batch_.evaluate(pipeline_, {});
    for (const auto& preset : plain->presets) bases.push_back({{plan::kPresetSetting, preset.name}});
    if (bases.empty()) bases.push_back({});
    for (const script::Settings& base : bases) walkBase(base);
    return std::move(walk_);
  }

 private:
  void walkBase(const script::Settings& base) {
    std::shared_ptr<const PipelineDesc> evaluated = take(base);
    if (!evaluated) return;
    std::set<std::string> known = nodesOf(*evaluated);
    for (const Try& one : triesIn(*evaluated, {})) {
      script::Settings sets = base;
      sets.push_back({one.name, plan::valueFromText(one.value)});
      if (auto changed = take(sets)) walkNew(sets, *changed, known, one.name);
    }
  }

  // Tries the parameters of nodes that only this value adds to the graph.
  void walkNew(const script::Settings& sets, const PipelineDesc& pipeline, const std::set<std::string>& known,
               const std::string& changed) {
    std::set<std::string> more = nodesOf(pipeline);
    if (std::includes(known.begin(), known.end(), more.begin(), more.end())) return;
    for (const Try& one : triesIn(pipeline, known)) {
      script::Settings further = sets;
      further.push_back({one.name, plan::valueFromText(one.value)});
      if (one.name != changed) take(further);
    }
  }

  // Adds the variant, unless it is refused or its plan is known. Returns the pipeline; null if refused.
  std::shared_ptr<const PipelineDesc> take(const script::Settings& sets) {
    Variant variant{pipeline_, sets, nullptr};
    try {
      variant.description = batch_.evaluate(pipeline_, sets);
    } catch (const lab::Refusal& refusal) {
      walk_.refused.push_back({variant.name(), refusal.what()});
      return nullptr;
    }
    lab::Shot shot;
    shot.width = shot.height = 64;
    bool is_new = seen_.insert(lab::identityOf(lab::planOf(shot, *variant.description, graph::Backend::Query))).second;
    if (is_new) walk_.variants.push_back(variant);
    else ++walk_.same;
    return variant.description;
  }

  lab::Batch& batch_;
  std::string pipeline_;
  VariantList walk_;
  std::set<std::string> seen_;
};

}  // namespace

VariantList walk(lab::Batch& batch, const std::string& pipeline) { return Walker(batch, pipeline).run(); }

// ---- declarations

static void addBreaks(std::vector<Declared>& found, const plan::Breaks& breaks, const std::string& invariant,
                      const std::string& where, const std::string& owner) {
  for (const auto& [name, reason] : breaks)
    if (name == invariant) found.push_back({where, reason, owner + ": " + invariant});
}

static void addValueBreaks(std::vector<Declared>& found, const ParamDesc& param, const plan::Value& value,
                           const std::string& invariant) {
  bool is_number = param.type == ParamDesc::Type::Int || param.type == ParamDesc::Type::Float;
  std::string named = !is_number ? textOf(value) : value != param.default_value ? plan::kOtherNumbers : "";
  for (const auto& [choice, breaks] : param.breaks) {
    if (choice != named) continue;
    std::string what = param.name + " = " + choice;
    addBreaks(found, breaks, invariant, what, what);
  }
}

// True for a parameter of a pass. Its declared breaks count only if the pass runs.
static bool isOfAPass(const ParamDesc& param) { return Home::withoutRoot(param.place.file).starts_with("passes/"); }

std::vector<Declared> declaredBreaks(const PipelineDesc& pipeline, const std::string& invariant) {
  std::vector<Declared> found;
  addBreaks(found, pipeline.breaks, invariant, "pipeline " + pipeline.name, "pipeline " + pipeline.name);
  for (const ParamDesc& param : pipeline.params)
    if (!isOfAPass(param)) addValueBreaks(found, param, *plan::valueOf(pipeline, param.name), invariant);
  for (const auto& node : pipeline.nodes) {
    const PassDesc& pass = passOf(pipeline, node);
    addBreaks(found, pass.breaks, invariant, "pass " + pass.name, "pass " + pass.name);
    for (const auto& [name, binding] : node.params)
      for (const ParamDesc& param : pass.params)
        if (param.name == name) addValueBreaks(found, param, *plan::valueOf(pipeline, binding), invariant);
  }
  std::set<std::string> keys;
  std::erase_if(found, [&](const Declared& one) { return !keys.insert(one.key).second; });
  return found;
}

double numberOf(const PipelineDesc& pipeline, const std::string& param, double otherwise) {
  const plan::Value* value = plan::valueOf(pipeline, param);
  if (!value) return otherwise;
  if (const auto* whole = std::get_if<int64_t>(value)) return double(*whole);
  if (const auto* number = std::get_if<double>(value)) return *number;
  return otherwise;
}

double numberOf(const PipelineDesc& pipeline, plan::Role role, double otherwise) {
  const ParamDesc* param = plan::paramOf(pipeline, role);
  return param ? numberOf(pipeline, param->name, otherwise) : otherwise;
}

int gridOf(const PipelineDesc& pipeline) {
  int grid = 1;
  for (const auto& node : pipeline.nodes) {
    const plan::SizeDesc& size = passOf(pipeline, node).size;
    for (const auto& [name, binding] : node.params)
      if (name == size.divide) grid = std::lcm(grid, int(std::get<int64_t>(*plan::valueOf(pipeline, binding))));
  }
  return grid;
}

}  // namespace strobe::stability
