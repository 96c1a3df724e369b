// SPDX-License-Identifier: MIT
// Values set in a pipeline's description without running its scripts again. Most parameters change numbers only, not
// the graph.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plan/description.h"

namespace strobe::plan {

// True if the value of PARAM decided the graph, or may have decided it. Always false for NODE.PARAM.
bool decidesGraph(const PipelineDesc& pipeline, const std::string& name);

// The description with these values. Names are PARAM or NODE.PARAM; none of these parameters may decide the graph.
// Throws `Error` for an unknown name, or a value that does not fit.
PipelineDesc withSettings(PipelineDesc pipeline, const std::vector<std::pair<std::string, Value>>& sets);

}  // namespace strobe::plan
