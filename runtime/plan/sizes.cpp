// SPDX-License-Identifier: MIT
#include "plan/sizes.h"

#include <algorithm>

#include "plan/named.h"

namespace strobe::plan {

static int divisorOf(const NodeDesc& node, const WiredNode& wired, const std::string& param) {
  constexpr int64_t kLargest = 1 << 20;  // keeps the sum of a side and a divisor in the range of int
  const int64_t number = param.empty() ? 1 : std::get<int64_t>(*valueIn(wired.params, param));
  if (number >= 1) return int(std::min(number, kLargest));
  throw Error(fmt::format("node '{}' divides its size by {} = {}", node.name, param, number), node.place);
}

NodeSize sizeOf(const PipelineDesc& pipeline, const Wiring& wiring, int node) {
  const WiredNode& wired = wiring.nodes[size_t(node)];
  const PassDesc& pass = pipeline.passes[size_t(wired.pass)];
  const SizeDesc& size = pass.size;
  if (size.kind == SizeDesc::Kind::Fixed) return {size.width, size.height, 0};
  if (size.kind == SizeDesc::Kind::Frame) return {wiring.width, wiring.height, 1};
  const NodeDesc& desc = pipeline.nodes[size_t(node)];
  const int input = wired.reads[size_t(indexOf(pass.reads, size.port))].node;
  if (input < 0)
    throw Error(fmt::format("node '{}' is as large as its input '{}', which is not wired", desc.name, size.port),
                desc.place);
  const NodeSize of_input = sizeOf(pipeline, wiring, input);
  const int divide = divisorOf(desc, wired, size.divide);
  return {(of_input.width + divide - 1) / divide, (of_input.height + divide - 1) / divide, of_input.divide * divide};
}

}  // namespace strobe::plan
