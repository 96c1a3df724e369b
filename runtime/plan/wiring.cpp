// SPDX-License-Identifier: MIT
#include "plan/wiring.h"

#include <algorithm>
#include <set>

#include "plan/description_words.h"
#include "plan/facts.h"
#include "plan/formats.h"

namespace strobe::plan {
namespace {

template <class Items>
int indexOf(const Items& items, const std::string& name) {
  for (size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

template <class Items>
std::vector<std::string> namesOf(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

template <class Pairs>
auto findKey(Pairs& pairs, const std::string& key) {
  return std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.first == key; });
}

std::vector<std::string> producedPorts(const PassDesc& pass) {
  std::vector<std::string> names = namesOf(pass.writes);
  for (const PortDesc& port : pass.updates) names.push_back(port.name);
  return names;
}

class Wirer {
 public:
  Wirer(const PipelineDesc& pipeline, const CompileOptions& options) : pipeline_(pipeline), options_(options) {}

  Wiring wire() {
    checkFrame();
    for (const PassDesc& pass : pipeline_.passes) checkPass(pass);
    checkUnique("pass", namesOf(pipeline_.passes));
    checkUnique("node", namesOf(pipeline_.nodes));
    checkUnique("loop", namesOf(pipeline_.loops));
    throwIfAny(problems_);

    findPasses();
    throwIfAny(problems_);  // the next steps look up ports in the passes

    checkOverrides();
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

  void checkPass(const PassDesc& pass) {
    checkPorts(pass, namesOf(pass.reads), "reads");
    checkPorts(pass, producedPorts(pass), "writes");
    if (pass.writes.empty() && pass.updates.empty()) problem(pass.place, "pass '{}' writes nothing", pass.name);
    if (pass.kind == PassDesc::Kind::Raster && !pass.updates.empty()) {
      problem(pass.place, "raster pass '{}' has updates; only compute and trace passes can", pass.name);
    }
    for (const auto* ports : {&pass.writes, &pass.updates}) {
      for (const PortDesc& port : *ports) checkFormat(pass, port);
    }
    for (const PortDesc& port : pass.reads) {
      if (!port.linear || !(port.uint || port.pointwise)) continue;
      problem(port.place, "read '{}' of pass '{}' is both {} and linear", port.name, pass.name,
              port.uint ? "uint" : "pointwise");
    }
    checkSize(pass);
  }

  // Names must be unique among reads and among writes. A read and a write may share a name.
  void checkPorts(const PassDesc& pass, const std::vector<std::string>& names, const char* does) {
    std::set<std::string> seen;
    for (const std::string& name : names) {
      if (!seen.insert(name).second) problem(pass.place, "pass '{}' {} '{}' twice", pass.name, does, name);
    }
  }

  void checkFormat(const PassDesc& pass, const PortDesc& port) {
    checkFormatName(pass, port, port.format);
    if (!port.format_by.empty()) checkChosenFormats(pass, port);
  }

  void checkFormatName(const PassDesc& pass, const PortDesc& port, const std::string& format) {
    if (indexOf(portFormats(), format) >= 0) return;
    problem(port.place, "port '{}' of pass '{}' has unknown format '{}'{}", port.name, pass.name, format,
            didYouMean(format, namesOf(portFormats())));
  }

  void checkChosenFormats(const PassDesc& pass, const PortDesc& port) {
    int by = indexOf(pass.params, port.format_by);
    if (by < 0) {
      problem(port.place,
              "the format of port '{}' of pass '{}' is chosen by '{}', which is not a parameter of the pass{}",
              port.name, pass.name, port.format_by, didYouMean(port.format_by, namesOf(pass.params)));
      return;
    }
    for (const std::string& choice : pass.params[by].choices) {
      if (findKey(port.formats, choice) != port.formats.end()) continue;
      problem(port.place, "port '{}' of pass '{}' has no format for '{}' = '{}'", port.name, pass.name, port.format_by,
              choice);
    }
    for (const auto& [choice, format] : port.formats) {
      checkFormatName(pass, port, format);
      const Format* known = findFormat(format);
      const Format* usual = findFormat(port.format);
      if (!known || !usual || known->uint == usual->uint) continue;
      problem(port.place, "the formats of port '{}' of pass '{}' mix unsigned integers and numbers: {} and {}",
              port.name, pass.name, port.format, format);
    }
  }

  void checkSize(const PassDesc& pass) {
    const SizeDesc& size = pass.size;
    if (size.kind == SizeDesc::Kind::Fixed) {
      bool fits = size.width >= 1 && size.height >= 1 && size.width <= kMaxSide && size.height <= kMaxSide;
      if (!fits)
        problem(pass.place, "pass '{}' has size {}x{}; sides are 1 to {}", pass.name, size.width, size.height,
                kMaxSide);
    }
    if (size.kind != SizeDesc::Kind::Port) return;
    if (indexOf(pass.reads, size.port) < 0) {
      problem(pass.place, "pass '{}' is as large as '{}', which it does not read{}", pass.name, size.port,
              didYouMean(size.port, namesOf(pass.reads)));
    }
    if (size.divide.empty()) return;
    int param = indexOf(pass.params, size.divide);
    if (param < 0) {
      problem(pass.place, "pass '{}' divides its size by '{}', which is not one of its parameters{}", pass.name,
              size.divide, didYouMean(size.divide, namesOf(pass.params)));
    } else if (pass.params[param].type != ParamDesc::Type::Int) {
      problem(pass.place, "pass '{}' divides its size by '{}', which is not an int", pass.name, size.divide);
    }
  }

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
      static const std::vector<std::string> times = {"raster", "shutter_open", "shutter_close", "sample"};
      if (std::find(times.begin(), times.end(), node.time) == times.end()) {
        problem(node.place, "node '{}' has unknown time '{}'{}", node.name, node.time, didYouMean(node.time, times));
      }
      if (node.time == "sample" && node.loop.empty()) {
        problem(node.place, "node '{}' has time 'sample' but is not in a loop", node.name);
      }
      bool traces = wired.pass >= 0 && pipeline_.passes[wired.pass].kind == PassDesc::Kind::Trace;
      if (traces && (node.time == "shutter_open" || node.time == "shutter_close")) {
        problem(node.place,
                "trace node '{}' has time '{}'; rays trace the scene at the raster time or, in a loop, at the sample",
                node.name, node.time);
      }
      wiring_.nodes.push_back(std::move(wired));
    }
  }

  // Checks that every key of `options.set` is a parameter of the pipeline or of a node.
  void checkOverrides() {
    std::vector<std::string> known = namesOf(pipeline_.params);
    for (const auto& [name, value] : pipeline_.values) known.push_back(name);
    for (size_t i = 0; i < pipeline_.nodes.size(); ++i) {
      for (const ParamDesc& param : passOf(static_cast<int>(i)).params) {
        known.push_back(pipeline_.nodes[i].name + "." + param.name);
      }
    }
    for (const auto& [name, value] : options_.set) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      problem({}, "pipeline '{}' has no parameter '{}'{}", pipeline_.name, name, didYouMean(name, known));
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
    for (const ParamDesc& param : pipeline_.params) {
      if (findKey(wiring_.values, param.name) == wiring_.values.end()) {
        wiring_.values.emplace_back(param.name, param.default_value);
      }
    }
    for (auto& [name, value] : wiring_.values) {
      auto set = options_.set.find(name);
      if (set != options_.set.end()) value = set->second;
      int param = indexOf(pipeline_.params, name);
      if (param >= 0) value = checked(pipeline_.params[param], value, {});
    }
  }

  // The value of a binding; `fallback` for an empty binding or an unknown parameter.
  Value valueOf(const Binding& binding, const Value& fallback) {
    if (binding.value) return *binding.value;
    if (binding.follows.empty()) return fallback;
    auto found = findKey(wiring_.values, binding.follows);
    if (found != wiring_.values.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, value] : wiring_.values) names.push_back(name);
    problem(binding.place, "pipeline '{}' has no parameter '{}'{}", pipeline_.name, binding.follows,
            didYouMean(binding.follows, names));
    return fallback;
  }

  // The port with the name "node.port". Otherwise adds a problem and returns node -1.
  Source sourceOf(const std::string& text, const std::string& reader, const Place& place) {
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
    std::vector<std::string> ports = producedPorts(pass);
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
    std::vector<Source>& reads = wiring_.nodes[index].reads;
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

  void checkTexels(const NodeDesc& node, const PortDesc& read, const Source& source, const std::string& text) {
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
      auto binding = findKey(node.params, param.name);
      Value value = param.default_value;
      Place place = param.place;
      if (binding != node.params.end()) {
        value = valueOf(binding->second, value);
        place = binding->second.place;
      }
      auto set = options_.set.find(node.name + "." + param.name);
      if (set != options_.set.end()) value = set->second, place = {};
      wiring_.nodes[index].params.emplace_back(param.name, checked(param, value, place));
    }
  }

  void resolveLoop(const LoopDesc& loop) {
    WiredLoop wired;
    wired.count = positive(valueOf(loop.count, int64_t{0}), "count", loop, loop.count.place);
    wired.slices = positive(valueOf(loop.slices, int64_t{1}), "slices", loop, loop.slices.place);
    Value times = valueOf(loop.times, std::string("midpoint"));
    const std::string* text = std::get_if<std::string>(&times);
    if (text) wired.times = *text;
    if (!text || std::find(kSampleTimes.begin(), kSampleTimes.end(), *text) == kSampleTimes.end()) {
      problem(loop.times.place, "times of loop '{}' must be one of {}", loop.name, fmt::join(kSampleTimes, ", "));
    }
    if (wired.times == kPartTimes) checkParts(loop, wired);
    wired.first = loop.first;
    wired.parts = loop.parts > 0 ? loop.parts : wired.count;
    if (wired.first < 0 || wired.count > wired.parts - wired.first)
      problem(loop.place, "loop '{}' takes {} parts of {} from number {} on, which is out of range", loop.name,
              wired.count, wired.parts, wired.first);
    if (!loop.until.empty()) wired.until = untilOf(loop);
    wiring_.loops.push_back(wired);
  }

  // Checks a loop of parts: a part has the poses of a frame, so the loop has no sample times.
  void checkParts(const LoopDesc& loop, const WiredLoop& wired) {
    if (wired.slices != 1) problem(loop.slices.place, "slices of loop '{}' must be 1: its times are parts", loop.name);
    for (const NodeDesc& node : pipeline_.nodes)
      if (node.loop == loop.name && node.time == "sample")
        problem(node.place,
                "node '{}' has time 'sample', but the times of loop '{}' are parts; use time 'raster' for the middle "
                "of a part",
                node.name, loop.name);
  }

  int positive(const Value& value, const char* what, const LoopDesc& loop, const Place& place) {
    const int64_t* number = std::get_if<int64_t>(&value);
    if (number && *number >= 1 && *number <= kMaxIterations) return static_cast<int>(*number);
    problem(place, "{} of loop '{}' must be an integer from 1 to {}", what, loop.name, kMaxIterations);
    return 1;
  }

  Source untilOf(const LoopDesc& loop) {
    Source source = sourceOf(loop.until, fmt::format("loop '{}'", loop.name), loop.place);
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
      Source source = sourceOf(text, fmt::format("output '{}'", name), place);
      if (source.node >= 0 && isBuffer(portOf(pipeline_, wiring_, source).format))
        problem(place, "output '{}' is '{}', a buffer instead of an image", name, text);
      bool asked_for = options_.outputs.empty() || options_.outputs.count(name);
      wiring_.outputs.push_back(asked_for ? source : Source());
    }
    bool has_color = findKey(pipeline_.outputs, "color") != pipeline_.outputs.end();
    if (!has_color) problem(place, "pipeline '{}' has no output 'color'", pipeline_.name);
  }

  const PassDesc& passOf(int node) const { return pipeline_.passes[wiring_.nodes[node].pass]; }

  static constexpr int kMaxSide = 16384;  // limit of every device with ray tracing
  static constexpr int kMaxIterations = 1 << 20;

  const PipelineDesc& pipeline_;
  const CompileOptions& options_;
  Wiring wiring_;
  std::vector<std::string> problems_;
};

}  // namespace

const PortDesc& portOf(const PipelineDesc& pipeline, const Wiring& wiring, const Source& source) {
  const PassDesc& pass = pipeline.passes[wiring.nodes[source.node].pass];
  size_t writes = pass.writes.size();
  size_t port = source.port;
  return port < writes ? pass.writes[port] : pass.updates[port - writes];
}

Wiring wire(const PipelineDesc& pipeline, const CompileOptions& options) { return Wirer(pipeline, options).wire(); }

}  // namespace strobe::plan
