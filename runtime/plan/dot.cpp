// SPDX-License-Identifier: MIT
#include "plan/dot.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace strobe::plan {
namespace {

const char* const kHead =
    "digraph plan {\n"
    "  rankdir=TB; ranksep=0.35; nodesep=0.3; bgcolor=white;\n"
    "  node [shape=box, style=\"filled,rounded\", fontname=\"DejaVu Sans\", fontsize=11, color=\"#5a6572\"];\n"
    "  edge [fontname=\"DejaVu Sans\", fontsize=9, color=\"#5a6572\", fontcolor=\"#39424d\"];\n";

// `text` as a quoted string of DOT.
std::string inQuotes(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"') result += '\\';
    result += c;
  }
  return result + "\"";
}

const char* const kFills[] = {"#f6e3c5", "#dbe7f3", "#f3cfc6"};  // in the order of kPassKinds

std::string boxOf(const Plan& plan, const PlanNode& node) {
  const PassDesc& pass = plan.passOf(node);
  const NodeDesc& desc = plan.descOf(node);
  const size_t kind = size_t(pass.kind);
  std::string label = desc.name;
  if (desc.name != pass.name) label += "\\npass " + pass.name;
  label += fmt::format("\\n{} {}x{}", kPassKinds[kind], node.width, node.height);
  return fmt::format("{} [label={}, fillcolor=\"{}\"];\n", inQuotes(desc.name), inQuotes(label), kFills[kind]);
}

void addBoxes(const Plan& plan, std::string& text) {
  for (size_t loop = 0; loop < plan.loops.size(); ++loop) {
    const PlanLoop& repeated = plan.loops[loop];
    std::string label = fmt::format("{}: {} times", plan.pipeline.loops[size_t(repeated.loop)].name, repeated.count);
    text += fmt::format("  subgraph cluster_{} {{\n    label={}; fontname=\"DejaVu Sans\"; fontsize=10;\n", loop,
                        inQuotes(label));
    for (const PlanNode& node : plan.nodes)
      if (node.loop == int(loop)) text += "    " + boxOf(plan, node);
    text += "  }\n";
  }
  for (const PlanNode& node : plan.nodes)
    if (node.loop < 0) text += "  " + boxOf(plan, node);
}

// "node" and "port" in the name of an image.
std::pair<std::string, std::string> halvesOf(const std::string& image) {
  size_t dot = image.rfind('.');
  return {image.substr(0, dot), image.substr(dot + 1)};
}

// A dashed box per node that does not run, but whose zeros are read.
void addZeros(const Plan& plan, std::string& text) {
  std::set<std::string> nodes;
  for (const VirtualImage& image : plan.images) {
    std::string node = halvesOf(image.name).first;
    if (image.zero && nodes.insert(node).second)
      text += fmt::format("  {} [label={}, style=dashed];\n", inQuotes(node), inQuotes(node + "\\n0"));
  }
}

void addEdges(const Plan& plan, std::string& text) {
  for (const PlanNode& node : plan.nodes) {
    std::map<std::string, std::string> ports;  // by node: the ports that are read, one per line
    for (int image : node.reads) {
      if (image < 0) continue;
      auto [from, port] = halvesOf(plan.images[size_t(image)].name);
      std::string& label = ports[from];
      label += (label.empty() ? "" : "\\n") + port;
    }
    for (const auto& [from, label] : ports)
      text += fmt::format("  {} -> {} [label={}];\n", inQuotes(from), inQuotes(plan.descOf(node).name),
                          inQuotes(" " + label));
  }
}

void addOutputs(const Plan& plan, std::string& text) {
  for (const auto& [name, image] : plan.outputs) {
    auto [from, port] = halvesOf(plan.images[size_t(image)].name);
    std::string id = inQuotes("output " + name);
    text += fmt::format("  {} [label={}, shape=ellipse, style=filled, fillcolor=\"#e3f0dc\"];\n", id, inQuotes(name));
    text += fmt::format("  {} -> {} [label={}, style=dashed];\n", inQuotes(from), id,
                        inQuotes(port == name ? "" : " " + port));
  }
}

}  // namespace

std::string toDot(const Plan& plan) {
  std::string text = kHead;
  addBoxes(plan, text);
  addZeros(plan, text);
  addEdges(plan, text);
  addOutputs(plan, text);
  return text + "}\n";
}

}  // namespace strobe::plan
