// SPDX-License-Identifier: MIT
// A description with names resolved to indices and parameters to values, checked: the first half of `compile`.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace strobe::plan {

// Port of an image: index of a node, and index of a port in the writes of the pass followed by its updates.
struct PortSource {
  int node = -1;
  int port = -1;
};

// Node of a render graph with its pass and loop as indices, the source of each image that it reads, and its parameter
// values.
struct WiredNode {
  int pass = -1;
  int loop = -1;
  std::vector<PortSource> reads;  // per read port of the pass; node -1 if not wired
  std::vector<std::pair<std::string, Value>> params;
  bool blank = false;  // the node does not run, and its ports read as zero
};

// Loop of a render graph with its resolved iteration count and sample times, and the source of its stop condition.
struct WiredLoop {
  PlanLoop loop;  // without `until`
  PortSource until;
};

// Render graph with all names resolved to indices: parameter values, nodes, loops, and the sources of outputs and taps.
struct Wiring {
  int width = 0, height = 0;                          // of the frame
  std::vector<std::pair<std::string, Value>> values;  // of the pipeline's parameters
  std::vector<WiredNode> nodes;                       // as in the description
  std::vector<WiredLoop> loops;
  std::vector<PortSource> outputs;  // as in the description; node -1 for outputs that are not requested
  std::vector<PortSource> taps;
};

// The port of `source`.
const PortDesc& portOf(const PipelineDesc& pipeline, const Wiring& wiring, const PortSource& source);

// Throws `Error` with every unknown name, mismatch and value out of range, or with the path of a cycle. The passes must
// be valid (`checkPass`).
Wiring wire(const PipelineDesc& pipeline, const CompileOptions& options);

}  // namespace strobe::plan
