// SPDX-License-Identifier: MIT
// Which nodes of a wired description run, and in which order.
#pragma once

#include <vector>

#include "plan/wiring.h"

namespace strobe::plan {

// Nodes that run directly after one another: one node, or those of one loop.
struct Unit {
  int loop = -1;
  std::vector<int> nodes;  // indices into the description, in the order of execution
};

// True for each node that an output, a tap or the stop condition of a needed loop needs.
std::vector<bool> neededNodes(const Wiring& wiring);

// The needed nodes such that each comes after what it reads and a loop's nodes are together; among those that may come
// next, the one called first. Throws `Error` with the path of a cycle, also of one among nodes that are not needed.
std::vector<Unit> orderNodes(const PipelineDesc& pipeline, const Wiring& wiring, const std::vector<bool>& needed);

}  // namespace strobe::plan
