// SPDX-License-Identifier: MIT
#include "plan/random_pipeline.h"

#include <random>

#include "plan/builder.h"
#include "plan/formats.h"

namespace strobe::plan::test {
namespace {

class Maker {
 public:
  explicit Maker(uint32_t seed) : random_(seed) {}

  RandomPipeline make() {
    int count = 4 + below(14);
    for (int i = 0; i < count; ++i) {
      moveLoop(i);
      addNode(fmt::format("n{}", i));
    }
    builder_.output("color", any(images_));
    for (int i = below(2); i > 0; --i) builder_.output(fmt::format("more{}", i), any(images_));

    RandomPipeline result;
    result.options.width = 40, result.options.height = 24;
    result.options.trace_stage = below(2) ? kStageTrace : kStageCompute;
    for (int i = below(3); i > 0; --i) result.options.taps.push_back(any(sources_));
    result.pipeline = std::move(builder_.pipeline);
    return result;
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<uint32_t>(limit)); }

  const std::string& any(const std::vector<std::string>& list) { return list[below(static_cast<int>(list.size()))]; }

  // Occasionally begins or ends a loop, so that the nodes of a loop are consecutive.
  void moveLoop(int node) {
    if (below(4) != 0) return;
    bool inside = !builder_.loop.empty();
    builder_.endLoop();
    if (!inside) builder_.beginLoop("l" + std::to_string(node), 1 + below(4));
  }

  void addNode(const std::string& name) {
    PassDesc::Kind kind = sources_.empty() ? PassDesc::Kind::Raster : static_cast<PassDesc::Kind>(below(3));
    std::vector<std::string> formats = {"r32f", "rgba16f", "r32ui"};
    if (kind != PassDesc::Kind::Raster) formats.push_back(kBufferFormat);
    Wires inputs;
    for (int i = sources_.empty() ? 0 : below(4); i > 0; --i) inputs.emplace_back("in" + std::to_string(i), pick());
    std::vector<std::string> writes, updates;
    for (int i = 1 + below(2); i > 0; --i) writes.push_back("w" + std::to_string(i) + " " + any(formats));
    if (kind != PassDesc::Kind::Raster && below(3) == 0) updates.push_back("u " + any(formats));

    PassDesc& pass = builder_.add(kind, name, inputs, writes, updates);
    if (below(5) == 0) pass.counters = {{"events", ""}};
    if (!inputs.empty() && below(4) == 0) {
      pass.size.kind = SizeDesc::Kind::Port;
      pass.size.port = inputs.front().first;
      pass.size.divide = "tile";
      pass.params = {intParam("tile", 1 + below(8), 1, 16)};
    }
    for (const PortDesc& read : pass.reads)
      if (read.buffer && kind != PassDesc::Kind::Raster && below(2)) pass.over = read.name;
    for (PortDesc& port : pass.writes) port.cleared = !pass.over.empty();
    for (const auto* ports : {&pass.writes, &pass.updates})
      for (const PortDesc& port : *ports) {
        sources_.push_back(name + "." + port.name);
        if (!isBuffer(port.format)) images_.push_back(sources_.back());
      }
  }

  // Prefers recent outputs, so that lifetimes end and slots are shared.
  const std::string& pick() {
    int count = static_cast<int>(sources_.size());
    return below(3) ? sources_[count - 1 - below(std::min(count, 4))] : any(sources_);
  }

  std::mt19937 random_;
  Builder builder_;
  std::vector<std::string> sources_, images_;
};

}  // namespace

RandomPipeline randomPipeline(uint32_t seed) { return Maker(seed).make(); }

}  // namespace strobe::plan::test
