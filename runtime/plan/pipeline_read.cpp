// SPDX-License-Identifier: MIT
// Checked reading of a pipeline in the canonical form.
#include <algorithm>
#include <set>

#include "base/json.h"
#include "plan/description_reader.h"
#include "plan/description_words.h"
#include "plan/formats.h"

namespace strobe::plan {

namespace {

const ParamDesc* checkFollows(const PipelineDesc& pipeline, const ParamDesc& param, const Binding& binding) {
  const ParamDesc* source = find(pipeline.params, binding.follows);
  if (!source) {
    std::string near = didYouMean(binding.follows, namesOf(pipeline.params));
    throw Error(fmt::format("the pipeline has no parameter '{}'{}", binding.follows, near), binding.place);
  }
  auto held = std::find_if(pipeline.values.begin(), pipeline.values.end(),
                           [&](const auto& entry) { return entry.first == source->name; });
  checkValue(param, held->second, binding.place);
  return source;
}

Binding readBinding(const Json& json, const PipelineDesc& pipeline, const ParamDesc& param) {
  Reader reader(json, fmt::format("parameter '{}'", param.name));
  Binding binding;
  binding.place = reader.place();
  if (reader.has("value") == reader.has("follows")) reader.fail("needs either 'value' or 'follows'");
  if (reader.has("value")) binding.value = checkValue(param, valueFromJson(reader.at("value")), binding.place);
  if (reader.has("follows")) binding.follows = reader.text("follows", std::nullopt);
  if (reader.has("follows")) checkFollows(pipeline, param, binding);
  reader.finish();
  return binding;
}

// The write or update with the name "node.port", or null.
const PortDesc* sourcePort(const PipelineDesc& pipeline, const std::string& source) {
  size_t dot = source.find('.');
  if (dot == std::string::npos) return nullptr;
  const NodeDesc* node = find(pipeline.nodes, source.substr(0, dot));
  const PassDesc* pass = node ? find(pipeline.passes, node->pass) : nullptr;
  if (!pass) return nullptr;
  const PortDesc* port = find(pass->writes, source.substr(dot + 1));
  return port ? port : find(pass->updates, source.substr(dot + 1));
}

const PortDesc& checkSource(const PipelineDesc& pipeline, const Json& source, const Place& place) {
  const PortDesc* port = source.is_string() ? sourcePort(pipeline, source.get<std::string>()) : nullptr;
  if (!port) throw Error(fmt::format("{} is not a port of an earlier node", source.dump()), place);
  return *port;
}

void readInputs(const Json& json, const PipelineDesc& pipeline, const PassDesc& pass, NodeDesc& node) {
  for (const auto& [name, source] : json.items()) {
    const PortDesc* read = find(pass.reads, name);
    if (!read) throw Error(fmt::format("pass '{}' has no read '{}'", pass.name, name), node.place);
    const PortDesc& port = checkSource(pipeline, source, node.place);
    if (isUint(port.format) != read->uint || isBuffer(port.format) != read->buffer) {
      throw Error(fmt::format("'{}' of '{}' cannot read {}", name, node.name, port.format), node.place);
    }
    node.inputs.emplace_back(name, source.get<std::string>());
  }
  for (const PortDesc& read : pass.reads) {
    if (read.optional || json.contains(read.name)) continue;
    throw Error(fmt::format("'{}' of '{}' is not wired", read.name, node.name), node.place);
  }
}

void readNodeParams(const Json& json, const PipelineDesc& pipeline, const PassDesc& pass, NodeDesc& node) {
  for (const auto& [name, binding] : json.items()) {
    const ParamDesc* param = find(pass.params, name);
    if (!param) throw Error(fmt::format("pass '{}' has no parameter '{}'", pass.name, name), node.place);
    node.params.emplace_back(name, readBinding(binding, pipeline, *param));
  }
  for (const ParamDesc& param : pass.params) {
    if (!json.contains(param.name)) {
      throw Error(fmt::format("parameter '{}' of '{}' has no value", param.name, node.name), node.place);
    }
  }
}

NodeDesc readNode(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "node");
  NodeDesc node;
  node.place = reader.place();
  node.name = nameOf(reader);
  node.pass = reader.text("pass", std::nullopt);
  if (find(pipeline.nodes, node.name)) reader.fail(fmt::format("two nodes are named '{}'", node.name));
  const PassDesc* pass = find(pipeline.passes, node.pass);
  if (!pass) reader.fail(fmt::format("unknown pass '{}'", node.pass));
  readInputs(reader.table("inputs"), pipeline, *pass, node);
  readNodeParams(reader.table("params"), pipeline, *pass, node);
  node.time = kNodeTimes[reader.oneOf("time", kNodeTimes)];
  node.loop = reader.text("loop");
  if (reader.has("runs")) node.runs = static_cast<Runs>(reader.oneOf("runs", kNodeRuns));
  if (node.runs == Runs::MovingInstances && pass->kind != PassDesc::Kind::Raster)
    reader.fail("only raster passes run for moving instances");
  bool in_loop = !node.loop.empty();
  if (in_loop && !find(pipeline.loops, node.loop)) reader.fail(fmt::format("unknown loop '{}'", node.loop));
  if (node.time == "sample" && !in_loop) reader.fail("time 'sample' exists only in a loop");
  reader.finish();
  return node;
}

ParamDesc countParam(const char* name, double max) {
  ParamDesc param;
  param.name = name;
  param.type = ParamDesc::Type::Int;
  param.min = 1;
  param.max = max;
  return param;
}

LoopDesc readLoop(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "loop");
  LoopDesc loop;
  loop.place = reader.place();
  loop.name = nameOf(reader);
  ParamDesc times;
  times.name = "times";
  times.type = ParamDesc::Type::Choice;
  times.choices = kSampleTimes;
  loop.count = readBinding(reader.at("count"), pipeline, countParam("count", 1 << 20));
  loop.times = readBinding(reader.at("times"), pipeline, times);
  loop.slices = readBinding(reader.at("slices"), pipeline, countParam("slices", 1024));
  loop.until = reader.text("until");
  if (json.contains("parts")) {
    loop.first = reader.integer("first", std::nullopt, 0, 1 << 20);
    loop.parts = reader.integer("parts", std::nullopt, 1, 1 << 20);
  }
  reader.finish();
  return loop;
}

void checkUntil(const PipelineDesc& pipeline, const LoopDesc& loop) {
  if (loop.until.empty()) return;
  const PortDesc& port = checkSource(pipeline, loop.until, loop.place);
  const NodeDesc* node = find(pipeline.nodes, loop.until.substr(0, loop.until.find('.')));
  bool fits = port.format == "r32f";
  for (const auto& [choice, format] : port.formats) fits &= format == "r32f";
  bool inside = node->loop == loop.name && fits;
  if (inside) return;
  throw Error(fmt::format("'{}' is not an r32f image written in loop '{}'", loop.until, loop.name), loop.place);
}

std::vector<std::string> namesIn(const Json& json, const PipelineDesc& pipeline) {
  std::vector<std::string> names;
  for (const Json& name : json) {
    bool known = name.is_string() && find(pipeline.params, name.get<std::string>());
    if (!known) throw Error(fmt::format("{} is not a parameter", name.dump()), {pipeline.file});
    names.push_back(name.get<std::string>());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void readValues(const Json& json, PipelineDesc& pipeline) {
  for (const ParamDesc& param : pipeline.params) {
    if (!json.contains(param.name)) throw Error(fmt::format("parameter '{}' has no value", param.name), param.place);
    pipeline.values.emplace_back(param.name, checkValue(param, valueFromJson(json[param.name]), param.place));
  }
  if (json.size() != pipeline.params.size()) throw Error("'values' has unknown parameters", {pipeline.file});
}

std::vector<std::pair<std::string, Value>> settingsOf(const Json& json) {
  std::vector<std::pair<std::string, Value>> settings;
  for (const auto& [name, value] : json.items()) settings.emplace_back(name, valueFromJson(value));
  return settings;
}

// Checks `when` only. The parameters in `set` are known after the other pipeline is evaluated.
EqualDesc readEqual(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "equal", {pipeline.file});
  EqualDesc equal{settingsOf(reader.table("when")), settingsOf(reader.table("set")),
                  reader.text("pipeline", std::nullopt)};
  for (const auto& [name, value] : equal.when) {
    const ParamDesc* param = find(pipeline.params, name);
    if (!param) reader.fail(fmt::format("unknown parameter '{}'", name));
    checkValue(*param, value, {pipeline.file});
  }
  reader.finish();
  return equal;
}

PresetDesc readPreset(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "preset", {pipeline.file});
  std::string name = reader.text("name", std::nullopt);
  if (!isName(name) && !name.ends_with(".lua")) reader.fail(fmt::format("'{}' is not the name of a preset", name));
  PresetDesc preset{name, reader.text("doc"), {}, reader.boolean("default", false)};
  for (const auto& [name, value] : settingsOf(reader.table("values"))) {
    const ParamDesc* param = paramNamed(pipeline, name);
    if (!param) reader.fail(fmt::format("'{}' sets the unknown parameter '{}'", preset.name, name));
    preset.values.emplace_back(name, checkValue(*param, value, {pipeline.file}));
  }
  reader.finish();
  return preset;
}

// Checks that exactly one preset is the default, and that the taken preset exists.
void readPresets(Reader& reader, PipelineDesc& pipeline) {
  pipeline.presets = itemsOf(reader.list("presets"), [&](const Json& preset) { return readPreset(preset, pipeline); });
  refuseTwins(pipeline.presets, reader, "presets");
  pipeline.preset = reader.text("preset");
  const auto& presets = pipeline.presets;
  auto defaults = std::count_if(presets.begin(), presets.end(), [](const auto& preset) { return preset.is_default; });
  if (defaults != (presets.empty() ? 0 : 1))
    reader.fail(fmt::format("{} presets are the default instead of one", defaults));
  bool taken = presets.empty() ? pipeline.preset.empty() : find(presets, pipeline.preset) != nullptr;
  if (!taken) reader.fail(fmt::format("unknown preset '{}'", pipeline.preset));
}

RegionDesc readRegion(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "region", {pipeline.file});
  RegionDesc region{nameOf(reader), reader.text("doc")};
  reader.finish();
  bool is_output = std::any_of(pipeline.outputs.begin(), pipeline.outputs.end(),
                               [&](const auto& output) { return output.first == region.name; });
  if (!is_output) reader.fail(fmt::format("unknown output '{}'", region.name));
  return region;
}

void refuseTwinRoles(const Reader& reader, const std::vector<ParamDesc>& params) {
  std::set<Role> seen;
  for (const ParamDesc& param : params) {
    bool is_new = param.role == Role::None || seen.insert(param.role).second;
    if (!is_new) reader.fail(fmt::format("two parameters have the role '{}'", roleName(param.role)));
  }
}

PassDesc passOf(const Reader& reader, const Json& json, const Known& known) {
  if (!json.is_number_integer()) return passFromJson(json);
  const int64_t number = json.get<int64_t>();
  if (number < 1 || uint64_t(number) > known.passes.size()) reader.fail(fmt::format("unknown pass number {}", number));
  return known.passes[size_t(number) - 1];
}

}  // namespace

Known knownFromJson(const Json& json) {
  Reader reader(json, "known declarations");
  Known known;
  known.params = itemsOf(reader.list("params"), readParam);
  for (const Json& pass : reader.list("passes")) known.passes.push_back(passFromJson(pass));
  reader.finish();
  return known;
}

PipelineDesc pipelineFromJson(const Json& json, const Known& known) {
  Reader reader(json, "pipeline");
  PipelineDesc pipeline;
  pipeline.name = reader.text("name", std::nullopt);
  pipeline.file = reader.text("file", std::nullopt);
  pipeline.doc = reader.text("doc");
  reader.setPlace({pipeline.file});
  if (reader.has("kind")) pipeline.kind = static_cast<PipelineDesc::Kind>(reader.oneOf("kind", pipelineKindNames()));
  pipeline.params = reader.has("params") ? itemsOf(reader.list("params"), readParam) : known.params;
  refuseTwins(pipeline.params, reader, "parameters");
  pipeline.graph_params = namesIn(reader.list("graph_params"), pipeline);
  refuseTwinRoles(reader, pipeline.params);
  readPresets(reader, pipeline);
  readValues(reader.table("values"), pipeline);
  if (reader.has("breaks")) pipeline.breaks = breaksOf(reader, reader.table("breaks"));
  pipeline.compare_with = reader.text("compare_with");
  pipeline.equals = itemsOf(reader.list("equals"), [&](const Json& equal) { return readEqual(equal, pipeline); });
  pipeline.passes = itemsOf(reader.list("passes"), [&](const Json& pass) { return passOf(reader, pass, known); });
  refuseTwins(pipeline.passes, reader, "passes");
  pipeline.loops = itemsOf(reader.list("loops"), [&](const Json& loop) { return readLoop(loop, pipeline); });
  refuseTwins(pipeline.loops, reader, "loops");
  for (const Json& node : reader.list("nodes")) pipeline.nodes.push_back(readNode(node, pipeline));
  for (const LoopDesc& loop : pipeline.loops) checkUntil(pipeline, loop);

  for (const auto& [name, source] : reader.table("outputs").items()) {
    if (!isName(name)) reader.fail(fmt::format("'{}' is not the name of an output", name));
    checkSource(pipeline, source, {pipeline.file});
    pipeline.outputs.emplace_back(name, source.get<std::string>());
  }
  if (!reader.table("outputs").contains("color")) reader.fail("output 'color' is missing");
  pipeline.regions = itemsOf(reader.list("regions"), [&](const Json& region) { return readRegion(region, pipeline); });
  refuseTwins(pipeline.regions, reader, "regions");
  reader.finish();
  return pipeline;
}

}  // namespace strobe::plan
