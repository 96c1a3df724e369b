// SPDX-License-Identifier: MIT
#include "plan/settings.h"

#include <algorithm>

namespace strobe::plan {

template <class List>
static auto* named(List& list, const std::string& name) {
  auto found = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  return found == list.end() ? nullptr : &*found;
}

bool decidesGraph(const PipelineDesc& pipeline, const std::string& name) {
  if (name == kPresetSetting) return true;  // a preset may set a parameter that decides the graph
  const auto& deciding = pipeline.graph_params;
  return std::find(deciding.begin(), deciding.end(), name) != deciding.end();
}

static void setOfPipeline(PipelineDesc& pipeline, const std::string& name, const Value& value) {
  const ParamDesc* param = named(pipeline.params, name);
  if (!param) throw Error(fmt::format("the pipeline has no parameter '{}'", name));
  for (auto& [held, present] : pipeline.values)
    if (held == name) present = checkValue(*param, value, {});
}

static void setOfNode(PipelineDesc& pipeline, const std::string& node_name, const std::string& name,
                      const Value& value) {
  NodeDesc* node = named(pipeline.nodes, node_name);
  if (!node) throw Error(fmt::format("unknown node '{}'", node_name));
  const ParamDesc* param = named(named(pipeline.passes, node->pass)->params, name);
  if (!param) throw Error(fmt::format("node '{}' has no parameter '{}'", node_name, name));
  if (param->wired) throw Error(fmt::format("only the pipeline sets '{}' of node '{}'", name, node_name));
  Binding bound{checkValue(*param, value, {}), "", {fmt::format("--set {}.{}={}", node_name, name, textOf(value)), 0}};
  for (auto& [held, binding] : node->params)
    if (held == name) binding = bound;
}

PipelineDesc withSettings(PipelineDesc pipeline, const std::vector<std::pair<std::string, Value>>& sets) {
  for (const auto& [name, value] : sets) {
    size_t dot = name.find('.');
    if (dot == std::string::npos) setOfPipeline(pipeline, name, value);
    else setOfNode(pipeline, name.substr(0, dot), name.substr(dot + 1), value);
  }
  return pipeline;
}

}  // namespace strobe::plan
