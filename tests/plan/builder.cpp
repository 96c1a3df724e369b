// SPDX-License-Identifier: MIT
#include "plan/builder.h"

#include <stdexcept>

#include "plan/formats.h"

namespace strobe::plan::test {

static PortDesc port(const std::string& text) {
  size_t space = text.find(' ');
  PortDesc port;
  port.name = text.substr(0, space);
  port.format = space == std::string::npos ? "r32f" : text.substr(space + 1);
  return port;
}

// Format of a declared port; "" if the port does not exist (tests of errors read missing ports).
static std::string formatOf(const PipelineDesc& pipeline, const std::string& source) {
  for (const PassDesc& pass : pipeline.passes) {
    for (const auto* ports : {&pass.writes, &pass.updates}) {
      for (const PortDesc& written : *ports) {
        if (pass.name + "." + written.name == source) return written.format;
      }
    }
  }
  return "";
}

Builder::Builder() {
  pipeline.name = "test";
  pipeline.file = "test.lua";
}

PassDesc& Builder::add(PassDesc::Kind kind, const std::string& name, const Wires& inputs,
                       const std::vector<std::string>& writes, const std::vector<std::string>& updates) {
  int line = static_cast<int>(pipeline.nodes.size()) + 1;
  PassDesc pass;
  pass.name = name;
  pass.kind = kind;
  pass.shader = "test/" + name;
  pass.place = {"passes/" + name + ".lua", 1};
  for (const auto& [read, source] : inputs) {
    PortDesc desc;
    desc.name = read;
    const Format* format = findFormat(formatOf(pipeline, source));
    desc.uint = format && format->uint;
    desc.buffer = format && isBuffer(format->name);
    pass.reads.push_back(desc);
  }
  for (const std::string& text : writes) pass.writes.push_back(port(text));
  for (const std::string& text : updates) pass.updates.push_back(port(text));
  NodeDesc node;
  node.name = node.pass = name;
  node.inputs = inputs;
  node.loop = loop;
  node.place = {"test.lua", line};
  pipeline.nodes.push_back(node);
  pipeline.passes.push_back(pass);
  return pipeline.passes.back();
}

PassDesc& Builder::raster(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes) {
  return add(PassDesc::Kind::Raster, name, inputs, writes);
}

PassDesc& Builder::compute(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes,
                           const std::vector<std::string>& updates) {
  return add(PassDesc::Kind::Compute, name, inputs, writes, updates);
}

PassDesc& Builder::trace(const std::string& name, const Wires& inputs, const std::vector<std::string>& writes,
                         const std::vector<std::string>& updates) {
  return add(PassDesc::Kind::Trace, name, inputs, writes, updates);
}

NodeDesc& Builder::node(const std::string& name) {
  for (NodeDesc& node : pipeline.nodes) {
    if (node.name == name) return node;
  }
  throw std::logic_error("no node " + name);
}

void Builder::beginLoop(const std::string& name, int count, const std::string& until) {
  LoopDesc desc;
  desc.name = name;
  desc.count = bound(int64_t{count});
  desc.until = until;
  desc.place = {"test.lua", 100};
  pipeline.loops.push_back(desc);
  loop = name;
}

void Builder::output(const std::string& name, const std::string& source) {
  pipeline.outputs.emplace_back(name, source);
}

Binding bound(Value value) {
  Binding binding;
  binding.value = std::move(value);
  return binding;
}

Binding following(const std::string& param) {
  Binding binding;
  binding.follows = param;
  return binding;
}

ParamDesc intParam(const std::string& name, int64_t value, double min, double max) {
  ParamDesc param;
  param.name = name;
  param.type = ParamDesc::Type::Int;
  param.default_value = value;
  param.min = min;
  param.max = max;
  param.place = {"passes/params.lua", 7};
  return param;
}

}  // namespace strobe::plan::test
