// SPDX-License-Identifier: MIT
// Sizes of the images that nodes write.
#pragma once

#include "plan/wiring.h"

namespace strobe::plan {

// Width and height in texels of all images that a node writes, and the number of frame pixels per texel along an axis.
struct NodeSize {
  int width = 0, height = 0;
  int divide = 1;  // as VirtualImage::divide
};

// Size of the images of a node. The wiring must not have cycles. Throws `Error` if the size depends on an input that is
// not wired, or if the divisor is less than 1.
NodeSize sizeOf(const PipelineDesc& pipeline, const Wiring& wiring, int node);

}  // namespace strobe::plan
