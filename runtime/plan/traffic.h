// SPDX-License-Identifier: MIT
// How much of a frame's images each pass touches, from its plan alone.
#pragma once

#include "plan/plan.h"

namespace strobe::plan {

// Bytes of one execution of a node: each image that it is wired to once, all of its texels. An image that is updated
// counts as read and as written. It is a lower bound of what a pass asks memory for where it touches every texel:
// texels that are read again, the scene's buffers and textures and what rays traverse are not in it.
struct Traffic {
  uint64_t read = 0, written = 0;
  uint64_t bytes() const { return read + written; }
};

// By node, as `plan.nodes`.
std::vector<Traffic> trafficOf(const Plan& plan);

}  // namespace strobe::plan
