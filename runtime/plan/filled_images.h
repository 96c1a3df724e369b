// SPDX-License-Identifier: MIT
// The images that the passes of a plan fill.
#pragma once

#include "plan/plan.h"

namespace strobe::plan {

// Calls `visit(node, image)` for each image that a pass fills, in the order of execution.
template <class Visit>
void forFilledImages(const Plan& plan, const Visit& visit) {
  for (const PlanNode& node : plan.nodes)
    for (const auto* images : {&node.writes, &node.updates})
      for (int image : *images) visit(node, plan.images[size_t(image)]);
}

// Names of the images that the passes fill, "NODE.PORT".
inline std::vector<std::string> filledImages(const Plan& plan) {
  std::vector<std::string> names;
  forFilledImages(plan, [&](const PlanNode&, const VirtualImage& image) { names.push_back(image.name); });
  return names;
}

}  // namespace strobe::plan
