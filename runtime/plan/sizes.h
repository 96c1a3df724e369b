// SPDX-License-Identifier: MIT
// How large the images are that nodes write.
#pragma once

#include <optional>
#include <vector>

#include "plan/wiring.h"

namespace strobe::plan {

struct NodeSize {
  int width = 0, height = 0;
  int divide = 1;  // as VirtualImage::divide
};

// Found when they are asked for. Description and wiring must outlive it; the wiring may change as long as what is read
// is as large as before, and has no cycles.
class Sizes {
 public:
  Sizes(const PipelineDesc& pipeline, const Wiring& wiring, int width, int height);

  // Throws `Error` where the node's size is that of an input that is not wired, or divided by less than 1.
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
