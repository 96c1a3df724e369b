// SPDX-License-Identifier: MIT
// What a frame does not require, taken out of a wiring.
#pragma once

#include <string>
#include <vector>

#include "plan/sizes.h"

namespace strobe::plan {

// Leaves out the nodes whose passes say what stands in for them where one of the facts `absent` does not hold or a read
// is nothing but zeros, and wires what stands in to whatever read them, outputs and taps included. A node runs all the
// same where an image could read back otherwise, which is so where what stands in has another format or size, and where
// a loop stops by it. Gives by node why it is left out; "" where it is not. The wiring has no cycles.
std::vector<std::string> leaveOut(const PipelineDesc& pipeline, const std::vector<std::string>& absent, Wiring& wiring,
                                  Sizes& sizes);

}  // namespace strobe::plan
