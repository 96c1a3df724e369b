// SPDX-License-Identifier: MIT
// Builds descriptions of pipelines for tests, a line per node.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plan/description.h"

namespace strobe::plan::test {

using Wires = std::vector<std::pair<std::string, std::string>>;  // read port -> "node.port"

// Makes one pass per node, with the same name. Ports are "name" (r32f) or "name format".
struct Builder {
  PipelineDesc pipeline;
  std::string loop;  // loop of the nodes added next

  Builder();

  // Returns the pass for further settings; the reference is valid until the next node is added.
  PassDesc& add(PassDesc::Kind kind, const std::string& name, const Wires& inputs,
                const std::vector<std::string>& writes, const std::vector<std::string>& updates = {});
  PassDesc& raster(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes);
  PassDesc& compute(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes,
                    const std::vector<std::string>& updates = {});
  PassDesc& trace(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes,
                  const std::vector<std::string>& updates = {});

  NodeDesc& node(const std::string& name);
  void beginLoop(const std::string& name, int count, const std::string& until = "");
  void endLoop() { loop.clear(); }
  void output(const std::string& name, const std::string& source);
};

Binding bound(Value value);
Binding following(const std::string& param);
ParamDesc intParam(const std::string& name, int64_t value, double min, double max);

}  // namespace strobe::plan::test
