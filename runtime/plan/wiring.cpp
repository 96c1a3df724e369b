// SPDX-License-Identifier: MIT
#include "plan/wiring.h"

#include <algorithm>
#include <set>

#include "base/lists.h"
#include "plan/facts.h"
#include "plan/formats.h"
#include "plan/named.h"
#include "plan/order.h"

namespace strobe::plan {
namespace {

class Wirer {
 public:
  Wirer(const PipelineDesc& pipeline, const CompileOptions& options) : pipeline_(pipeline), options_(options) {}

  Wiring wire() {
    checkFrame();
    wiring_.width = options_.width, wiring_.height = options_.height;
    checkUnique("pass", namesOf(pipeline_.passes));
    checkUnique("node", namesOf(pipeline_.nodes));
    checkUnique("loop", namesOf(pipeline_.loops));
    checkUnique("parameter", namesOf(pipeline_.params));
    checkUnique("preset", namesOf(pipeline_.presets));
    checkUnique("region", namesOf(pipeline_.regions));
    findPasses();
    throwIfAny(problems_);  // the next steps look up ports in the passes

    resolveValues();
    for (size_t i = 0; i < pipeline_.nodes.size(); ++i) {
      resolveInputs(static_cast<int>(i));
      resolveParams(static_cast<int>(i));
    }
    for (const LoopDesc& loop : pipeline_.loops) resolveLoop(loop);
    resolveOutputs();
    throwIfAny(problems_);

    for (const std::string& tap : options_.taps)
      wiring_.taps.push_back(sourceOf(tap, fmt::format("tap '{}'", tap), {}));
    throwIfAny(problems_, 2);
    refuseCycles(pipeline_, wiring_);
    return std::move(wiring_);
  }

 private:
  template <class... Args>
  void problem(const Place& place, fmt::format_string<Args...> format, Args&&... args) {
    problems_.push_back(Error(fmt::format(format, std::forward<Args>(args)...), place).what());
  }

  void checkFrame() {
    bool fits =
        options_.width >= 1 && options_.height >= 1 && options_.width <= kMaxSide && options_.height <= kMaxSide;
    if (!fits) problem({}, "a frame of {}x{} pixels; sides are 1 to {}", options_.width, options_.height, kMaxSide);
    for (const std::string& fact : options_.absent) STROBE_ASSERT(findFact(fact), "{}", fact);
    bool traces = options_.trace_stage == kStageCompute || options_.trace_stage == kStageTrace;
    STROBE_ASSERT(traces, "trace stage {}", static_cast<uint32_t>(options_.trace_stage));
  }

  void checkUnique(const char* what, const std::vector<std::string>& names) {
    std::set<std::string> seen;
    for (const std::string& name : names) {
      if (!seen.insert(name).second) problem({pipeline_.file}, "two {}{} named '{}'", what, plural(what), name);
    }
  }

  static const char* plural(std::string_view what) { return what.ends_with("s") ? "es" : "s"; }

  void findPasses() {
    for (const NodeDesc& node : pipeline_.nodes) {
      WiredNode wired;
      wired.pass = indexOf(pipeline_.passes, node.pass);
      if (wired.pass < 0) {
        problem(node.place, "node '{}' uses unknown pass '{}'{}", node.name, node.pass,
                didYouMean(node.pass, namesOf(pipeline_.passes)));
      }
      wired.loop = node.loop.empty() ? -1 : indexOf(pipeline_.loops, node.loop);
      if (!node.loop.empty() && wired.loop < 0) {
        problem(node.place, "node '{}' is in unknown loop '{}'{}", node.name, node.loop,
                didYouMean(node.loop, namesOf(pipeline_.loops)));
      }
      if (node.time == "sample" && node.loop.empty()) {
        problem(node.place, "node '{}' has time 'sample' but is not in a loop", node.name);
      }
      auto is = [&](PassDesc::Kind kind) { return wired.pass >= 0 && pipeline_.passes[wired.pass].kind == kind; };
      if (node.runs == Runs::MovingInstances && !is(PassDesc::Kind::Raster))
        problem(node.place, "node '{}' runs for moving instances, but its pass is not a raster pass", node.name);
      if (is(PassDesc::Kind::Trace) && (node.time == "shutter_open" || node.time == "shutter_close")) {
        problem(node.place,
                "trace node '{}' has time '{}'; rays trace the scene at the raster time or, in a loop, at the sample",
                node.name, node.time);
      }
      wiring_.nodes.push_back(std::move(wired));
    }
  }

  // `value` as the type of `param`. A mistake is added to the problems, and `value` is returned unchanged.
  Value checked(const ParamDesc& param, const Value& value, const Place& place) {
    try {
      return checkValue(param, value, place);
    } catch (const Error& error) {
      problems_.push_back(error.what());
      return value;
    }
  }

  void resolveValues() {
    wiring_.values = pipeline_.values;
    for (const ParamDesc& param : pipeline_.params)
      if (!valueIn(wiring_.values, param.name)) wiring_.values.emplace_back(param.name, param.default_value);
    for (auto& [name, value] : wiring_.values)
      if (const ParamDesc* param = find(pipeline_.params, name)) value = checked(*param, value, {});
  }

  // The value of a binding; `fallback` for an empty binding or an unknown parameter.
  Value valueOf(const Binding& binding, const Value& fallback) {
    if (binding.value) return *binding.value;
    if (binding.follows.empty()) return fallback;
    if (const Value* found = valueIn(wiring_.values, binding.follows)) return *found;
    std::vector<std::string> names;
    for (const auto& [name, value] : wiring_.values) names.push_back(name);
    problem(binding.place, "pipeline '{}' has no parameter '{}'{}", pipeline_.name, binding.follows,
            didYouMean(binding.follows, names));
    return fallback;
  }

  // The port with the name "node.port". Otherwise adds a problem and returns node -1.
  PortSource sourceOf(const std::string& text, const std::string& reader, const Place& place) {
    size_t dot = text.find('.');
    std::string node_name = text.substr(0, dot);
    std::string port_name = dot == std::string::npos ? "" : text.substr(dot + 1);
    int node = indexOf(pipeline_.nodes, node_name);
    if (node < 0) {
      problem(place, "{} reads '{}', but node '{}' is unknown{}", reader, text, node_name,
              didYouMean(node_name, namesOf(pipeline_.nodes)));
      return {};
    }
    const PassDesc& pass = passOf(node);
    std::vector<std::string> ports = outputsOf(pass);
    if (port_name.empty()) {
      problem(place, "{} reads '{}', which is a node and not an image; use '{}.NAME' with one of {}", reader, text,
              node_name, fmt::join(ports, ", "));
      return {};
    }
    auto port = std::find(ports.begin(), ports.end(), port_name);
    if (port != ports.end()) return {node, static_cast<int>(port - ports.begin())};
    if (indexOf(pass.reads, port_name) >= 0) {
      problem(place, "{} reads '{}' before it is written: node '{}' only reads it", reader, text, node_name);
    } else {
      problem(place, "{} reads '{}', but pass '{}' does not write '{}'{}", reader, text, pass.name, port_name,
              didYouMean(port_name, ports));
    }
    return {};
  }

  void resolveInputs(int index) {
    const NodeDesc& node = pipeline_.nodes[index];
    const PassDesc& pass = passOf(index);
    std::vector<PortSource>& reads = wiring_.nodes[index].reads;
    reads.resize(pass.reads.size());
    std::set<std::string> wired;
    for (const auto& [port_name, text] : node.inputs) {
      int port = indexOf(pass.reads, port_name);
      if (port < 0) {
        problem(node.place, "pass '{}' has no input '{}'{}", pass.name, port_name,
                didYouMean(port_name, namesOf(pass.reads)));
        continue;
      }
      if (!wired.insert(port_name).second) {
        problem(node.place, "input '{}' of node '{}' is wired twice", port_name, node.name);
      }
      reads[port] = sourceOf(text, fmt::format("node '{}'", node.name), node.place);
      if (reads[port].node >= 0) checkTexels(node, pass.reads[port], reads[port], text);
    }
    for (const PortDesc& port : pass.reads) {
      if (port.optional || wired.count(port.name)) continue;
      problem(node.place, "node '{}' lacks the input '{}' of pass '{}'", node.name, port.name, pass.name);
    }
  }

  void checkTexels(const NodeDesc& node, const PortDesc& read, const PortSource& source, const std::string& text) {
    const PortDesc& written = portOf(pipeline_, wiring_, source);
    if (isBuffer(written.format) != read.buffer) {
      problem(node.place, "node '{}' reads '{}' as {}, but '{}' is {} ({})", node.name, read.name,
              read.buffer ? "a buffer" : "an image", text, written.format, written.place.text());
      return;
    }
    if (findFormat(written.format)->uint == read.uint) return;
    problem(node.place, "node '{}' reads '{}' as {}, but '{}' is {} ({})", node.name, read.name,
            read.uint ? "unsigned integers" : "numbers", text, written.format, written.place.text());
  }

  void resolveParams(int index) {
    const NodeDesc& node = pipeline_.nodes[index];
    const PassDesc& pass = passOf(index);
    for (const auto& [name, binding] : node.params) {
      if (indexOf(pass.params, name) >= 0) continue;
      problem(binding.place, "pass '{}' has no parameter '{}'{}", pass.name, name,
              didYouMean(name, namesOf(pass.params)));
    }
    for (const ParamDesc& param : pass.params) {
      const Binding* binding = valueIn(node.params, param.name);
      const Value value = binding ? valueOf(*binding, param.default_value) : param.default_value;
      wiring_.nodes[index].params.emplace_back(param.name,
                                               checked(param, value, binding ? binding->place : param.place));
    }
  }

  void resolveLoop(const LoopDesc& loop) {
    PlanLoop wired;
    wired.loop = static_cast<int>(wiring_.loops.size());
    wired.count = positive(valueOf(loop.count, int64_t{0}), kMaxIterations, "count", loop, loop.count.place);
    wired.slices = positive(valueOf(loop.slices, int64_t{1}), kMaxSlices, "slices", loop, loop.slices.place);
    Value times = valueOf(loop.times, std::string("midpoint"));
    const std::string* text = std::get_if<std::string>(&times);
    if (text) wired.times = *text;
    if (!text || !contains(kSampleTimes, *text)) {
      problem(loop.times.place, "times of loop '{}' must be one of {}", loop.name, fmt::join(kSampleTimes, ", "));
    }
    if (wired.times == kPartTimes) checkParts(loop, wired);
    wired.first = loop.first;
    wired.parts = loop.parts > 0 ? loop.parts : wired.count;
    if (wired.first < 0 || wired.count > wired.parts - wired.first)
      problem(loop.place, "loop '{}' takes {} parts of {} from number {} on, which is out of range", loop.name,
              wired.count, wired.parts, wired.first);
    wiring_.loops.push_back({wired, loop.until.empty() ? PortSource() : untilOf(loop)});
  }

  // Checks a loop of parts: a part has the poses of a frame, so the loop has no sample times.
  void checkParts(const LoopDesc& loop, const PlanLoop& wired) {
    if (wired.slices != 1) problem(loop.slices.place, "slices of loop '{}' must be 1: its times are parts", loop.name);
    for (const NodeDesc& node : pipeline_.nodes)
      if (node.loop == loop.name && node.time == "sample")
        problem(node.place,
                "node '{}' has time 'sample', but the times of loop '{}' are parts; use time 'raster' for the middle "
                "of a part",
                node.name, loop.name);
  }

  int positive(const Value& value, int most, const char* what, const LoopDesc& loop, const Place& place) {
    const int64_t* number = std::get_if<int64_t>(&value);
    if (number && *number >= 1 && *number <= most) return static_cast<int>(*number);
    problem(place, "{} of loop '{}' must be an integer from 1 to {}", what, loop.name, most);
    return 1;
  }

  PortSource untilOf(const LoopDesc& loop) {
    PortSource source = sourceOf(loop.until, fmt::format("loop '{}'", loop.name), loop.place);
    if (source.node < 0) return source;
    if (pipeline_.nodes[source.node].loop != loop.name) {
      problem(loop.place, "loop '{}' stops on '{}', which is not in the loop", loop.name, loop.until);
    }
    const PortDesc& port = portOf(pipeline_, wiring_, source);
    if (formatOf(port, wiring_.nodes[source.node].params) != "r32f") {
      problem(loop.place, "loop '{}' stops on '{}', which is not r32f", loop.name, loop.until);
    }
    return source;
  }

  void resolveOutputs() {
    Place place{pipeline_.file};
    for (const auto& [name, text] : pipeline_.outputs) {
      PortSource source = sourceOf(text, fmt::format("output '{}'", name), place);
      if (source.node >= 0 && isBuffer(portOf(pipeline_, wiring_, source).format))
        problem(place, "output '{}' is '{}', a buffer instead of an image", name, text);
      bool asked_for = options_.outputs.empty() || options_.outputs.count(name);
      wiring_.outputs.push_back(asked_for ? source : PortSource());
    }
    if (!valueIn(pipeline_.outputs, "color")) problem(place, "pipeline '{}' has no output 'color'", pipeline_.name);
  }

  const PassDesc& passOf(int node) const { return pipeline_.passes[wiring_.nodes[node].pass]; }

  static constexpr int kMaxIterations = 1 << 20, kMaxSlices = 1024;

  const PipelineDesc& pipeline_;
  const CompileOptions& options_;
  Wiring wiring_;
  std::vector<std::string> problems_;
};

}  // namespace

const PortDesc& portOf(const PipelineDesc& pipeline, const Wiring& wiring, const PortSource& source) {
  const PassDesc& pass = pipeline.passes[wiring.nodes[source.node].pass];
  size_t writes = pass.writes.size();
  size_t port = source.port;
  return port < writes ? pass.writes[port] : pass.updates[port - writes];
}

Wiring wire(const PipelineDesc& pipeline, const CompileOptions& options) { return Wirer(pipeline, options).wire(); }

}  // namespace strobe::plan
