// SPDX-License-Identifier: MIT
// Removal of the nodes that a frame does not need from a wiring.
#pragma once

#include <string>
#include <vector>

#include "plan/wiring.h"

namespace strobe::plan {

// Marks nodes as left out if their passes have stand-ins for a missing fact (`absent`) or for a read that is only
// zeros. Readers, outputs and taps are wired to the stand-ins. A node still runs if its stand-in has another format or
// size, or if a loop stops by its image. Returns the reason per node; "" for nodes that run. The wiring must not have
// cycles.
std::vector<std::string> leaveOut(const PipelineDesc& pipeline, const std::vector<std::string>& absent, Wiring& wiring);

}  // namespace strobe::plan
