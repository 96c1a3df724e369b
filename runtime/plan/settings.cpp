// SPDX-License-Identifier: MIT
#include "plan/settings.h"

#include "base/lists.h"
#include "plan/named.h"

namespace strobe::plan {

bool decidesGraph(const PipelineDesc& pipeline, const std::string& name) {
  if (name == kPresetSetting) return true;  // a preset may set a parameter that decides the graph
  return contains(pipeline.graph_params, name);
}

static void setOfPipeline(PipelineDesc& pipeline, const std::string& name, const Value& value) {
  const ParamDesc* param = find(pipeline.params, name);
  if (!param) throw Error(fmt::format("the pipeline has no parameter '{}'", name));
  if (Value* held = valueIn(pipeline.values, name)) *held = checkValue(*param, value, {});
}

static void setOfNode(PipelineDesc& pipeline, const std::string& node_name, const std::string& name,
                      const Value& value) {
  NodeDesc* node = find(pipeline.nodes, node_name);
  if (!node) throw Error(fmt::format("unknown node '{}'", node_name));
  const ParamDesc* param = find(find(pipeline.passes, node->pass)->params, name);
  if (!param) throw Error(fmt::format("node '{}' has no parameter '{}'", node_name, name));
  if (param->wired) throw Error(fmt::format("only the pipeline sets '{}' of node '{}'", name, node_name));
  Binding bound{checkValue(*param, value, {}), "", {fmt::format("--set {}.{}={}", node_name, name, textOf(value)), 0}};
  if (Binding* held = valueIn(node->params, name)) *held = bound;
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
