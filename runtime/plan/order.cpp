// SPDX-License-Identifier: MIT
#include "plan/order.h"

#include <algorithm>
#include <set>

namespace strobe::plan {
namespace {

// Per vertex: the vertices that it depends on.
using Dependencies = std::vector<std::set<int>>;

Dependencies nodeDependencies(const Wiring& wiring) {
  Dependencies dependencies(wiring.nodes.size());
  for (size_t i = 0; i < wiring.nodes.size(); ++i) {
    for (const PortSource& source : wiring.nodes[i].reads) {
      if (source.node >= 0) dependencies[i].insert(source.node);
    }
  }
  return dependencies;
}

// Depth-first search along dependencies; `path` has the vertices from the start to the current one.
bool findCycleFrom(int vertex, const Dependencies& dependencies, std::vector<int>& mark, std::vector<int>& path) {
  constexpr int kOpen = 1, kDone = 2;
  path.push_back(vertex);
  mark[vertex] = kOpen;
  for (int next : dependencies[vertex]) {
    if (mark[next] == kOpen) {
      path.erase(path.begin(), std::find(path.begin(), path.end(), next));
      return true;
    }
    if (mark[next] == 0 && findCycleFrom(next, dependencies, mark, path)) return true;
  }
  mark[vertex] = kDone;
  path.pop_back();
  return false;
}

// The vertices of a cycle in the direction of the data flow, starting with the smallest; empty without a cycle.
std::vector<int> findCycle(const Dependencies& dependencies) {
  std::vector<int> mark(dependencies.size(), 0), path;
  for (size_t i = 0; i < dependencies.size(); ++i) {
    if (mark[i] != 0 || !findCycleFrom(static_cast<int>(i), dependencies, mark, path)) continue;
    std::reverse(path.begin(), path.end());
    std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());
    return path;
  }
  return {};
}

std::string pathText(const std::vector<int>& cycle, const std::vector<std::string>& names) {
  std::string text;
  for (int vertex : cycle) text += names[vertex] + " -> ";
  return text + names[cycle.front()];
}

void refuseNodeCycle(const PipelineDesc& pipeline, const Wiring& wiring) {
  std::vector<int> cycle = findCycle(nodeDependencies(wiring));
  if (cycle.empty()) return;
  std::vector<std::string> names;
  for (const NodeDesc& node : pipeline.nodes) names.push_back(node.name);
  throw Error("cycle: " + pathText(cycle, names), pipeline.nodes[cycle.front()].place);
}

// One unit per node, and one unit per loop for its nodes, in the order of the first call.
struct Units {
  std::vector<Unit> units;
  std::vector<int> of_node;  // index into `units`; -1 for nodes left out
};

Units makeUnits(const Wiring& wiring, const std::vector<bool>& needed) {
  Units result;
  result.of_node.assign(wiring.nodes.size(), -1);
  std::vector<int> of_loop(wiring.loops.size(), -1);
  for (size_t i = 0; i < wiring.nodes.size(); ++i) {
    if (!needed[i] || wiring.nodes[i].blank) continue;
    int loop = wiring.nodes[i].loop;
    int unit = loop < 0 ? -1 : of_loop[loop];
    if (unit < 0) {
      unit = static_cast<int>(result.units.size());
      result.units.push_back({loop, {}});
    }
    if (loop >= 0) of_loop[loop] = unit;
    result.units[unit].nodes.push_back(static_cast<int>(i));
    result.of_node[i] = unit;
  }
  return result;
}

Dependencies unitDependencies(const Units& units, const Dependencies& of_nodes) {
  Dependencies dependencies(units.units.size());
  for (size_t i = 0; i < of_nodes.size(); ++i) {
    int unit = units.of_node[i];
    if (unit < 0) continue;
    for (int source : of_nodes[i]) {
      int other = units.of_node[source];
      if (other >= 0 && other != unit) dependencies[unit].insert(other);
    }
  }
  return dependencies;
}

// Throws if a loop feeds a node outside that feeds the loop again: the nodes of the loop cannot run together then.
void refuseUnitCycle(const PipelineDesc& pipeline, const Units& units, const Dependencies& dependencies) {
  std::vector<int> cycle = findCycle(dependencies);
  if (cycle.empty()) return;
  std::vector<std::string> names;
  for (const Unit& unit : units.units) {
    bool loop = unit.loop >= 0;
    names.push_back(loop ? "loop " + pipeline.loops[unit.loop].name : pipeline.nodes[unit.nodes.front()].name);
  }
  throw Error("cycle through a loop, whose nodes run together: " + pathText(cycle, names),
              pipeline.nodes[units.units[cycle.front()].nodes.front()].place);
}

// Repeatedly takes the first vertex with all dependencies done. `candidates` is ascending.
std::vector<int> topological(const Dependencies& dependencies, std::vector<int> candidates) {
  std::set<int> open(candidates.begin(), candidates.end());
  std::vector<int> order;
  while (!open.empty()) {
    auto ready = [&](int vertex) {
      return std::none_of(dependencies[vertex].begin(), dependencies[vertex].end(),
                          [&](int source) { return open.count(source) > 0; });
    };
    auto next = std::find_if(open.begin(), open.end(), ready);
    STROBE_ASSERT(next != open.end(), "cycles are refused before");
    order.push_back(*next);
    open.erase(next);
  }
  return order;
}

}  // namespace

std::vector<bool> neededNodes(const Wiring& wiring) {
  std::vector<bool> needed(wiring.nodes.size(), false);
  std::vector<int> open;
  auto need = [&](const PortSource& source) {
    if (source.node < 0 || needed[source.node]) return;
    needed[source.node] = true;
    open.push_back(source.node);
  };
  for (const PortSource& source : wiring.outputs) need(source);
  for (const PortSource& source : wiring.taps) need(source);
  while (!open.empty()) {
    const WiredNode& node = wiring.nodes[open.back()];
    open.pop_back();
    if (node.blank) continue;
    for (const PortSource& source : node.reads) need(source);
    if (node.loop >= 0) need(wiring.loops[node.loop].until);
  }
  return needed;
}

void refuseCycles(const PipelineDesc& pipeline, const Wiring& wiring) {
  refuseNodeCycle(pipeline, wiring);
  Units all = makeUnits(wiring, std::vector<bool>(wiring.nodes.size(), true));
  refuseUnitCycle(pipeline, all, unitDependencies(all, nodeDependencies(wiring)));
}

std::vector<Unit> orderNodes(const Wiring& wiring, const std::vector<bool>& needed) {
  Dependencies of_nodes = nodeDependencies(wiring);
  Units units = makeUnits(wiring, needed);
  std::vector<int> every_unit(units.units.size());
  for (size_t i = 0; i < every_unit.size(); ++i) every_unit[i] = static_cast<int>(i);
  std::vector<Unit> ordered;
  for (int index : topological(unitDependencies(units, of_nodes), every_unit)) {
    Unit unit = units.units[index];
    unit.nodes = topological(of_nodes, unit.nodes);
    ordered.push_back(std::move(unit));
  }
  return ordered;
}

}  // namespace strobe::plan
