// SPDX-License-Identifier: MIT
// A plan as a graph for Graphviz.
#pragma once

#include <string>

#include "plan/plan.h"

namespace strobe::plan {

// DOT: a box per node with name, pass, kind and size, in the order of execution; an edge per pair of nodes, labelled
// with the ports read; an ellipse per output; a cluster per loop. The same text for the same plan.
std::string toDot(const Plan& plan);

}  // namespace strobe::plan
