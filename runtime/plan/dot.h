// SPDX-License-Identifier: MIT
// A plan as a graph for Graphviz.
#pragma once

#include <string>

#include "plan/plan.h"

namespace strobe::plan {

// DOT: a box per node with name, pass, kind and size, in the order of execution; an edge per pair of nodes, labelled
// with the ports that are read; an ellipse per output; a cluster per loop. Equal plans give equal texts.
std::string toDot(const Plan& plan);

}  // namespace strobe::plan
