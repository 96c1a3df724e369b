// SPDX-License-Identifier: MIT
// Checked reading of a pipeline in the canonical form.
#include <algorithm>
#include <set>

#include "base/json.h"
#include "plan/description_reader.h"
#include "plan/wiring.h"

namespace strobe::plan {

namespace {

Binding readBinding(const Json& json, const std::string& name) {
  Reader reader(json, fmt::format("parameter '{}'", name));
  Binding binding;
  binding.place = reader.place();
  if (reader.has("value") == reader.has("follows")) reader.fail("needs either 'value' or 'follows'");
  if (reader.has("value")) binding.value = valueFromJson(reader.at("value"));
  else binding.follows = reader.text("follows");
  reader.finish();
  return binding;
}

NodeDesc readNode(const Json& json) {
  Reader reader(json, "node");
  NodeDesc node;
  node.place = reader.place();
  node.name = nameOf(reader);
  node.pass = reader.text("pass", std::nullopt);
  node.inputs = textsByName(reader, "inputs");
  for (const auto& [name, binding] : reader.table("params").items())
    node.params.emplace_back(name, readBinding(binding, name));
  node.time = kNodeTimes[reader.oneOf("time", kNodeTimes)];
  node.loop = reader.text("loop");
  if (reader.has("runs")) node.runs = static_cast<Runs>(reader.oneOf("runs", kNodeRuns));
  reader.finish();
  return node;
}

LoopDesc readLoop(const Json& json) {
  Reader reader(json, "loop");
  LoopDesc loop;
  loop.place = reader.place();
  loop.name = nameOf(reader);
  loop.count = readBinding(reader.at("count"), "count");
  loop.times = readBinding(reader.at("times"), "times");
  loop.slices = readBinding(reader.at("slices"), "slices");
  loop.until = reader.text("until");
  loop.first = reader.integer("first", 0, 0, 1 << 20);
  loop.parts = reader.integer("parts", 0, 1, 1 << 20);
  reader.finish();
  return loop;
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
    const ParamDesc* param = find(pipeline.params, name);
    if (!param) reader.fail(fmt::format("'{}' sets the unknown parameter '{}'", preset.name, name));
    preset.values.emplace_back(name, checkValue(*param, value, {pipeline.file}));
  }
  reader.finish();
  return preset;
}

// Checks that exactly one preset is the default, and that the taken preset exists.
void readPresets(Reader& reader, PipelineDesc& pipeline) {
  pipeline.presets = itemsOf(reader.list("presets"), [&](const Json& preset) { return readPreset(preset, pipeline); });
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
  if (!valueIn(pipeline.outputs, region.name)) reader.fail(fmt::format("unknown output '{}'", region.name));
  return region;
}

void refuseTwinRoles(const Reader& reader, const std::vector<ParamDesc>& params) {
  std::set<Role> seen;
  for (const ParamDesc& param : params) {
    bool is_new = param.role == Role::None || seen.insert(param.role).second;
    if (!is_new)
      reader.fail(fmt::format("two parameters have the role '{}'", roleNames()[static_cast<size_t>(param.role) - 1]));
  }
}

}  // namespace

std::vector<ParamDesc> paramsFromJson(const Json& list) { return itemsOf(list, readParam); }

PipelineDesc pipelineFromJson(const Json& json, SharedParts parts) {
  Reader reader(json, "pipeline");
  PipelineDesc pipeline;
  pipeline.name = reader.text("name", std::nullopt);
  pipeline.file = reader.text("file", std::nullopt);
  pipeline.doc = reader.text("doc");
  reader.setPlace({pipeline.file});
  if (reader.has("kind")) pipeline.kind = static_cast<PipelineDesc::Kind>(reader.oneOf("kind", pipelineKindNames()));
  pipeline.params = reader.has("params") ? itemsOf(reader.list("params"), readParam) : std::move(parts.params);
  pipeline.graph_params = namesIn(reader.list("graph_params"), pipeline);
  refuseTwinRoles(reader, pipeline.params);
  readPresets(reader, pipeline);
  readValues(reader.table("values"), pipeline);
  if (reader.has("breaks")) pipeline.breaks = breaksOf(reader, reader.table("breaks"));
  pipeline.compare_with = reader.text("compare_with");
  pipeline.equals = itemsOf(reader.list("equals"), [&](const Json& equal) { return readEqual(equal, pipeline); });
  pipeline.passes = reader.has("passes") ? itemsOf(reader.list("passes"), passFromJson) : std::move(parts.passes);
  pipeline.loops = itemsOf(reader.list("loops"), readLoop);
  pipeline.nodes = itemsOf(reader.list("nodes"), readNode);
  pipeline.outputs = textsByName(reader, "outputs");
  for (const auto& [name, source] : pipeline.outputs)
    if (!isName(name)) reader.fail(fmt::format("'{}' is not the name of an output", name));
  pipeline.regions = itemsOf(reader.list("regions"), [&](const Json& region) { return readRegion(region, pipeline); });
  reader.finish();
  CompileOptions any_frame;
  any_frame.width = any_frame.height = 1;
  wire(pipeline, any_frame);  // checks references and values
  return pipeline;
}

}  // namespace strobe::plan
