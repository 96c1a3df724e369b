// SPDX-License-Identifier: MIT
#include "study/own.h"

#include "plan/plan.h"

namespace strobe::study {

// Pass of each node in the plan, by the name of the node.
static std::map<std::string, std::string> passesOf(const plan::Plan& plan) {
  std::map<std::string, std::string> passes;
  for (const plan::PlanNode& node : plan.nodes) {
    const plan::NodeDesc& described = plan.descOf(node);
    passes[described.name] = described.pass;
  }
  return passes;
}

std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot) {
  lab::Shot sharp = shot;
  sharp.pipeline = batch.nameOf(plan::PipelineDesc::Kind::Sharp);
  sharp.sets = lab::sceneSettings(shot.sets);
  sharp.taps.clear();
  std::map<std::string, std::string> captured = passesOf(*batch.planOf(sharp));
  std::set<std::string> nodes;
  for (const auto& [name, pass] : passesOf(*batch.planOf(shot))) {
    auto same = captured.find(name);
    if (same != captured.end() && same->second == pass) nodes.insert(name);
  }
  return nodes;
}

std::vector<double> ownMs(lab::Batch& batch, const lab::Shot& shot, const lab::Timing& timing) {
  std::set<std::string> captured = capturedNodes(batch, shot);
  std::vector<double> ms(timing.ms.size(), 0);
  for (const auto& [name, by_round] : timing.passes)
    for (size_t i = 0; i < ms.size() && !captured.count(name); ++i) ms[i] += by_round[i];
  return ms;
}

}  // namespace strobe::study
