// SPDX-License-Identifier: MIT
// Selection of the nodes that run, and their order.
#pragma once

#include <vector>

#include "plan/wiring.h"

namespace strobe::plan {

// Nodes that run directly after one another: one node, or the nodes of one loop.
struct Unit {
  int loop = -1;
  std::vector<int> nodes;  // indices into the description, in the order of execution
};

// Throws `Error` with the path of a cycle of nodes, or of loops (the nodes of a loop run together).
void refuseCycles(const PipelineDesc& pipeline, const Wiring& wiring);

// True for each node that an output, a tap or the stop condition of a needed loop needs. Blank nodes need no inputs.
std::vector<bool> neededNodes(const Wiring& wiring);

// The needed nodes that run, in order: each node comes after the nodes that it reads, and the nodes of a loop are
// together. Among nodes that may come next, the first in the order of the calls is taken. The wiring must not have
// cycles.
std::vector<Unit> orderNodes(const Wiring& wiring, const std::vector<bool>& needed);

}  // namespace strobe::plan
