// SPDX-License-Identifier: MIT
// Values put into a pipeline's description as its scripts would, without running them: most parameters decide nothing
// but numbers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plan/description.h"

namespace strobe::plan {

// Whether the value of PARAM decided the graph that the scripts made, or might have. Of NODE.PARAM never.
bool decidesGraph(const PipelineDesc& pipeline, const std::string& name);

// The description with these values (PARAM or NODE.PARAM, none of which decides the graph). Throws `Error` for a name
// that is no parameter, or a value that does not fit.
PipelineDesc withSettings(PipelineDesc pipeline, const std::vector<std::pair<std::string, Value>>& sets);

}  // namespace strobe::plan
