// SPDX-License-Identifier: MIT
// Sizes of the images that nodes write.
#pragma once

#include <optional>
#include <vector>

#include "plan/wiring.h"

namespace strobe::plan {

// Width and height in texels of all images that a node writes, and the number of frame pixels per texel along an axis.
struct NodeSize {
  int width = 0, height = 0;
  int divide = 1;  // as VirtualImage::divide
};

// Sizes by node, computed on demand. The description and the wiring must outlive this object. The wiring may change if
// the sizes of all reads stay the same, and must not have cycles.
class Sizes {
 public:
  Sizes(const PipelineDesc& pipeline, const Wiring& wiring, int width, int height);

  // Size of the images of a node. Throws `Error` if the size depends on an input that is not wired, or if the divisor
  // is less than 1.
  const NodeSize& of(int node);

 private:
  NodeSize found(int node);
  NodeSize dividedInput(int node);
  int divisor(int node, const std::string& param) const;

  const PipelineDesc& pipeline_;
  const Wiring& wiring_;
  int width_, height_;
  std::vector<std::optional<NodeSize>> known_;
};

}  // namespace strobe::plan
