// SPDX-License-Identifier: MIT
// Amount of image data that each pass accesses, computed from the plan alone.
#pragma once

#include "plan/plan.h"

namespace strobe::plan {

// Bytes of one execution of a node: all texels of each image that the node is wired to, counted once. An updated image
// counts as read and as written. If the pass accesses every texel, this is a lower bound of its memory traffic: texels
// that are read again, the scene's buffers and textures, and the data of ray traversal are not included.
struct Traffic {
  uint64_t read = 0, written = 0;
  uint64_t bytes() const { return read + written; }
};

// Traffic per node, in the order of `plan.nodes`.
std::vector<Traffic> trafficOf(const Plan& plan);

}  // namespace strobe::plan
