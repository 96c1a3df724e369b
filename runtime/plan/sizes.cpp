// SPDX-License-Identifier: MIT
#include "plan/sizes.h"

#include <algorithm>

#include "plan/named.h"

namespace strobe::plan {

Sizes::Sizes(const PipelineDesc& pipeline, const Wiring& wiring, int width, int height)
    : pipeline_(pipeline), wiring_(wiring), width_(width), height_(height), known_(wiring.nodes.size()) {}

const NodeSize& Sizes::of(int node) {
  std::optional<NodeSize>& size = known_[size_t(node)];
  if (!size) size = found(node);
  return *size;
}

NodeSize Sizes::found(int node) {
  const SizeDesc& size = pipeline_.passes[size_t(wiring_.nodes[size_t(node)].pass)].size;
  if (size.kind == SizeDesc::Kind::Fixed) return {size.width, size.height, 0};
  return size.kind == SizeDesc::Kind::Port ? dividedInput(node) : NodeSize{width_, height_, 1};
}

NodeSize Sizes::dividedInput(int node) {
  const WiredNode& wired = wiring_.nodes[size_t(node)];
  const PassDesc& pass = pipeline_.passes[size_t(wired.pass)];
  const int input = wired.reads[size_t(indexOf(pass.reads, pass.size.port))].node;
  if (input < 0) {
    const NodeDesc& desc = pipeline_.nodes[size_t(node)];
    throw Error(fmt::format("node '{}' is as large as its input '{}', which is not wired", desc.name, pass.size.port),
                desc.place);
  }
  NodeSize size = of(input);
  int divide = pass.size.divide.empty() ? 1 : divisor(node, pass.size.divide);
  return {(size.width + divide - 1) / divide, (size.height + divide - 1) / divide, size.divide * divide};
}

int Sizes::divisor(int node, const std::string& param) const {
  constexpr int64_t kLargest = 1 << 20;  // keeps the sum of a side and a divisor in the range of int
  const int64_t number = std::get<int64_t>(*valueIn(wiring_.nodes[size_t(node)].params, param));
  if (number >= 1) return int(std::min(number, kLargest));
  const NodeDesc& desc = pipeline_.nodes[size_t(node)];
  throw Error(fmt::format("node '{}' divides its size by {} = {}", desc.name, param, number), desc.place);
}

}  // namespace strobe::plan
