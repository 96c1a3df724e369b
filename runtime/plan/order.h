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

// Throws `Error` with the path of a cycle of nodes, or of loops whose nodes run together.
void refuseCycles(const PipelineDesc& pipeline, const Wiring& wiring);

// True for each node that an output, a tap or the stop condition of a needed loop needs; blank ones need nothing.
std::vector<bool> neededNodes(const Wiring& wiring);

// The needed nodes that run, such that each comes after what it reads and a loop's nodes are together; among those that
// may come next, the one called first. There are no cycles.
std::vector<Unit> orderNodes(const Wiring& wiring, const std::vector<bool>& needed);

}  // namespace strobe::plan
