// SPDX-License-Identifier: MIT
#include "plan/traffic.h"

#include <set>

#include "plan/formats.h"

namespace strobe::plan {

static uint64_t bytesOf(const Plan& plan, const std::set<int>& images) {
  uint64_t bytes = 0;
  for (int index : images) {
    if (index < 0) continue;
    const VirtualImage& image = plan.images[size_t(index)];
    bytes += bytesOf(image.format, image.width, image.height);
  }
  return bytes;
}

static Traffic trafficOf(const Plan& plan, const PlanNode& node) {
  std::set<int> read(node.reads.begin(), node.reads.end()), written(node.writes.begin(), node.writes.end());
  read.insert(node.updates.begin(), node.updates.end());
  written.insert(node.updates.begin(), node.updates.end());
  written.insert(node.depth);
  return {bytesOf(plan, read), bytesOf(plan, written)};
}

std::vector<Traffic> trafficOf(const Plan& plan) {
  std::vector<Traffic> traffic;
  for (const PlanNode& node : plan.nodes) traffic.push_back(trafficOf(plan, node));
  return traffic;
}

}  // namespace strobe::plan
