// SPDX-License-Identifier: MIT
#include "plan/description.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/json.h"
#include "plan/description_words.h"
#include "plan/formats.h"
#include "plan/without.h"

namespace strobe::plan {

const std::vector<std::string>& formatNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Format& format : portFormats()) list.push_back(format.name);
    return list;
  }();
  return names;
}

const std::vector<std::string>& invariantNames() {
  static const std::vector<std::string> names = {"constant",   "still",    "brief",   "mirrored", "shifted",
                                                 "reversed",   "convex",   "uniform", "linear",   "scaled",
                                                 "converging", "unmasked", "finite",  "permuted"};
  return names;
}

const std::vector<std::string>& roleNames() {
  static const std::vector<std::string> names = {"tile",    "sample_count", "reach",   "depth_tolerance", "jitter",
                                                 "shading", "sample_times", "regions", "static_once",     "quality"};
  return names;
}

const std::vector<std::string>& pipelineKindNames() {
  static const std::vector<std::string> names = {"method", "sharp", "truth", "list"};
  return names;
}

std::string roleName(Role role) { return role == Role::None ? "" : roleNames()[static_cast<size_t>(role) - 1]; }

// ---- look-up in a pipeline

const ParamDesc* paramNamed(const PipelineDesc& pipeline, const std::string& name) {
  auto found =
      std::find_if(pipeline.params.begin(), pipeline.params.end(), [&](const auto& p) { return p.name == name; });
  return found == pipeline.params.end() ? nullptr : &*found;
}

const ParamDesc* paramOf(const PipelineDesc& pipeline, Role role) {
  auto found =
      std::find_if(pipeline.params.begin(), pipeline.params.end(), [&](const auto& p) { return p.role == role; });
  return found == pipeline.params.end() ? nullptr : &*found;
}

const Value* valueOf(const PipelineDesc& pipeline, const std::string& name) {
  for (const auto& [other, value] : pipeline.values)
    if (other == name) return &value;
  return nullptr;
}

// The integer of a binding; `otherwise` if its value does not follow from the parameters of the pipeline.
static int64_t wholeOf(const PipelineDesc& pipeline, const Binding& binding, int64_t otherwise) {
  const Value* value = binding.value ? &*binding.value : valueOf(pipeline, binding.follows);
  const int64_t* number = value ? std::get_if<int64_t>(value) : nullptr;
  return number ? *number : otherwise;
}

static bool hasTimes(const PipelineDesc& pipeline, const LoopDesc& loop, const char* wanted) {
  const Value* times = loop.times.value ? &*loop.times.value : valueOf(pipeline, loop.times.follows);
  return times && *times == Value(std::string(wanted));
}

int earlierFrames(const PipelineDesc& pipeline) {
  constexpr int64_t kMost = 64;
  int64_t most = 0;
  for (const LoopDesc& loop : pipeline.loops) {
    if (!hasTimes(pipeline, loop, "frames")) continue;
    const int64_t parts = loop.parts > 0 ? loop.parts : wholeOf(pipeline, loop.count, 1);
    most = std::max(most, parts * wholeOf(pipeline, loop.slices, 1));
  }
  return int(std::min(most, kMost));
}

bool hasParts(const PipelineDesc& pipeline) {
  return std::any_of(pipeline.loops.begin(), pipeline.loops.end(),
                     [&](const LoopDesc& loop) { return hasTimes(pipeline, loop, kPartTimes); });
}

// ---- values

Json toJson(const Value& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Value valueFromJson(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_unsigned() && json.get<uint64_t>() > static_cast<uint64_t>(INT64_MAX)) {
    throw Error("a value is too large for an integer");
  }
  if (json.is_number_integer()) return json.get<int64_t>();
  if (json.is_number_float() && std::isfinite(json.get<double>())) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  throw Error("a value must be true or false, a number or a text");
}

std::string textOf(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<int64_t>(&value)) return fmt::format("{}", *whole);
  std::string text = fmt::format("{}", std::get<double>(value));
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

static std::string shown(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("'{}'", *text);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* whole = std::get_if<int64_t>(&value)) return fmt::format("{}", *whole);
  return std::get<bool>(value) ? "true" : "false";
}

template <class Number>
static std::optional<Number> parsed(const std::string& text) {
  Number number{};
  auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Value valueFromText(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  // Digits that are not the usual form of an integer ("007") may be the name of a choice.
  if (auto whole = parsed<int64_t>(text)) return textOf(*whole) == text ? Value(*whole) : Value(text);
  auto number = parsed<double>(text);
  if (number && std::isfinite(*number)) return *number;
  return text;
}

static std::optional<int64_t> asInteger(const Value& value) {
  if (const auto* whole = std::get_if<int64_t>(&value)) return *whole;
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (auto whole = parsed<int64_t>(*text)) return whole;
    if (auto number = parsed<double>(*text)) return asInteger(Value(*number));
    return std::nullopt;
  }
  const auto* number = std::get_if<double>(&value);
  bool whole = number && std::floor(*number) == *number && std::abs(*number) < 0x1p53;
  return whole ? std::optional<int64_t>(static_cast<int64_t>(*number)) : std::nullopt;
}

static std::optional<double> asNumber(const Value& value) {
  if (const auto* whole = std::get_if<int64_t>(&value)) return static_cast<double>(*whole);
  std::optional<double> number;
  if (const auto* given = std::get_if<double>(&value)) number = *given;
  if (const auto* text = std::get_if<std::string>(&value)) number = parsed<double>(*text);
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return *number + 0.0;  // no negative zero
}

static std::optional<bool> asBool(const Value& value) {
  if (const auto* given = std::get_if<bool>(&value)) return *given;
  const auto* text = std::get_if<std::string>(&value);
  if (text && *text == "true") return true;
  if (text && *text == "false") return false;
  return std::nullopt;
}

static void checkRange(const ParamDesc& param, double number, const Value& value, const Place& where) {
  auto range = [&] {
    if (!param.min || !param.max) return std::string();
    std::string unit = param.unit.empty() ? "" : " " + param.unit;
    return fmt::format(" (range {} to {}{})", *param.min, *param.max, unit);
  };
  if (param.min && number < *param.min) {
    throw Error(fmt::format("'{}' = {} is below min {}{}", param.name, shown(value), *param.min, range()), where);
  }
  if (param.max && number > *param.max) {
    throw Error(fmt::format("'{}' = {} is above max {}{}", param.name, shown(value), *param.max, range()), where);
  }
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

static Value checkChoice(const ParamDesc& param, const Value& value, const Place& where) {
  // The name of a choice may be "2" or "true".
  std::string name = textOf(value);
  if (std::find(param.choices.begin(), param.choices.end(), name) != param.choices.end()) return name;
  std::string near = std::holds_alternative<std::string>(value) ? didYouMean(name, param.choices) : "";
  std::string choices = listed(param.choices);
  throw Error(fmt::format("'{}' = {} is not one of {}{}", param.name, shown(value), choices, near), where);
}

Value checkValue(const ParamDesc& param, const Value& value, const Place& where) {
  auto wants = [&](const char* what) {
    throw Error(fmt::format("'{}' = {} is not {}", param.name, shown(value), what), where);
  };
  if (param.type == ParamDesc::Type::Choice) return checkChoice(param, value, where);
  if (param.type == ParamDesc::Type::Bool) {
    std::optional<bool> flag = asBool(value);
    if (!flag) wants("true or false");
    return *flag;
  }
  if (param.type == ParamDesc::Type::Int) {
    std::optional<int64_t> whole = asInteger(value);
    if (!whole) wants("an integer");
    checkRange(param, static_cast<double>(*whole), value, where);
    return *whole;
  }
  if (param.has_auto && (value == Value("auto") || asNumber(value) == kAuto)) return kAuto;
  std::optional<double> number = asNumber(value);
  if (!number) wants(param.has_auto ? "a number or auto" : "a number");
  checkRange(param, *number, value, where);
  return *number;
}

// ---- formats

bool hasAbsent(const PortDesc& read) { return !read.absent.empty() || !read.absent_read.empty(); }

bool isCleared(const PortDesc& port) { return port.cleared || isBuffer(port.format); }

const std::string& formatOf(const PortDesc& port, const std::vector<std::pair<std::string, Value>>& params) {
  if (port.format_by.empty()) return port.format;
  auto named = [](const auto& list, const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; });
  };
  auto param = named(params, port.format_by);
  const std::string* choice = param == params.end() ? nullptr : std::get_if<std::string>(&param->second);
  if (!choice) return port.format;
  auto chosen = named(port.formats, *choice);
  return chosen == port.formats.end() ? port.format : chosen->second;
}

// ---- writing

template <class Item, class Write>
static Json listOf(const std::vector<Item>& items, Write write) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(write(item));
  return list;
}

static Json placeJson(const Place& place) { return {{"file", place.file}, {"line", place.line}}; }

static Json breaksJson(const Breaks& breaks) {
  Json json = Json::object();
  for (const auto& [invariant, reason] : breaks) json[invariant] = reason;
  return json;
}

// Bounds of an integer parameter are written as integers.
static Json boundJson(const ParamDesc& param, double bound) {
  if (param.type == ParamDesc::Type::Int) return static_cast<int64_t>(bound);
  return bound;
}

static Json paramJson(const ParamDesc& param) {
  Json json = {{"name", param.name}, {"type", kParamTypes[static_cast<size_t>(param.type)]}};
  json["default"] = toJson(param.default_value);
  if (param.min) json["min"] = boundJson(param, *param.min);
  if (param.max) json["max"] = boundJson(param, *param.max);
  if (param.has_auto) json["auto"] = true;
  if (param.type == ParamDesc::Type::Choice) json["choices"] = param.choices;
  for (const auto& [name, text] : param.values) json["values"][name] = text;
  for (const auto& [value, breaks] : param.breaks) json["breaks"][value] = breaksJson(breaks);
  if (param.role != Role::None) json["role"] = roleName(param.role);
  json["unit"] = param.unit;
  json["doc"] = param.doc;
  if (param.wired) json["wired"] = true;
  json["variant"] = param.variant;
  json["place"] = placeJson(param.place);
  return json;
}

static Json readJson(const PortDesc& port) {
  Json json = {{"name", port.name},         {"doc", port.doc},       {"uint", port.uint},
               {"optional", port.optional}, {"linear", port.linear}, {"place", placeJson(port.place)}};
  if (port.buffer) json["buffer"] = true;
  if (port.pointwise) json["pointwise"] = true;
  if (!port.needs.empty()) json["needs"] = port.needs;
  if (!port.absent.empty()) json["absent"] = port.absent;
  if (!port.absent_read.empty()) json["absent"] = port.absent_read;
  return json;
}

static Json writeJson(const PortDesc& port) {
  Json json = {{"name", port.name}, {"doc", port.doc}, {"format", port.format}, {"place", placeJson(port.place)}};
  if (!port.format_by.empty()) json["format_by"] = port.format_by;
  for (const auto& [choice, format] : port.formats) json["formats"][choice] = format;
  if (port.each != 1) json["each"] = port.each;
  if (port.cleared) json["cleared"] = true;
  if (port.history) json["history"] = true;
  return json;
}

static Json sizeJson(const SizeDesc& size) {
  Json json = {{"kind", kSizeKinds[static_cast<size_t>(size.kind)]}};
  if (size.kind == SizeDesc::Kind::Port) json["port"] = size.port;
  if (size.kind == SizeDesc::Kind::Port && !size.divide.empty()) json["divide"] = size.divide;
  if (size.kind == SizeDesc::Kind::Fixed) json["width"] = size.width, json["height"] = size.height;
  if (size.kind != SizeDesc::Kind::Frame) json["place"] = placeJson(size.place);
  return json;
}

static Json counterJson(const CounterDesc& counter) {
  Json json = {{"name", counter.name}, {"doc", counter.doc}};
  if (!counter.limit.empty()) json["limit"] = counter.limit;
  return json;
}

Json toJson(const PassDesc& pass) {
  Json json = {{"name", pass.name}, {"kind", kPassKinds[static_cast<size_t>(pass.kind)]}, {"shader", pass.shader}};
  json["doc"] = pass.doc;
  json["fails"] = pass.fails;
  if (!pass.breaks.empty()) json["breaks"] = breaksJson(pass.breaks);
  json["size"] = sizeJson(pass.size);
  if (!pass.over.empty()) json["over"] = pass.over;
  if (pass.group) json["group"] = true;
  json["scene"] = pass.scene;
  json["reads"] = listOf(pass.reads, readJson);
  json["writes"] = listOf(pass.writes, writeJson);
  json["updates"] = listOf(pass.updates, writeJson);
  json["params"] = listOf(pass.params, paramJson);
  json["counters"] = listOf(pass.counters, counterJson);
  if (!pass.without.empty()) json["without"] = listOf(pass.without, [](const auto& one) { return toJson(one); });
  json["place"] = placeJson(pass.place);
  return json;
}

static Json bindingJson(const Binding& binding) {
  Json json;
  if (binding.value) json["value"] = toJson(*binding.value);
  if (!binding.value) json["follows"] = binding.follows;
  json["place"] = placeJson(binding.place);
  return json;
}

static Json nodeJson(const NodeDesc& node) {
  Json json = {{"name", node.name}, {"pass", node.pass}};
  json["inputs"] = Json::object();
  for (const auto& [port, source] : node.inputs) json["inputs"][port] = source;
  json["params"] = Json::object();
  for (const auto& [name, binding] : node.params) json["params"][name] = bindingJson(binding);
  json["time"] = node.time;
  json["loop"] = node.loop;
  if (node.runs != Runs::MovingRect) json["runs"] = kNodeRuns[static_cast<size_t>(node.runs)];
  json["place"] = placeJson(node.place);
  return json;
}

static Json loopJson(const LoopDesc& loop) {
  Json json = {{"name", loop.name},
               {"count", bindingJson(loop.count)},
               {"times", bindingJson(loop.times)},
               {"slices", bindingJson(loop.slices)},
               {"until", loop.until},
               {"place", placeJson(loop.place)}};
  if (loop.parts > 0) json["first"] = loop.first, json["parts"] = loop.parts;
  return json;
}

static Json valuesJson(const std::vector<std::pair<std::string, Value>>& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = toJson(value);
  return json;
}

static Json equalJson(const EqualDesc& equal) {
  return {{"when", valuesJson(equal.when)}, {"pipeline", equal.pipeline}, {"set", valuesJson(equal.set)}};
}

static Json presetJson(const PresetDesc& preset) {
  return {{"name", preset.name},
          {"doc", preset.doc},
          {"default", preset.is_default},
          {"values", valuesJson(preset.values)}};
}

static Json regionJson(const RegionDesc& region) { return {{"name", region.name}, {"doc", region.doc}}; }

Json toJson(const PipelineDesc& pipeline) {
  Json json = {{"name", pipeline.name}, {"file", pipeline.file}, {"doc", pipeline.doc}};
  json["kind"] = pipelineKindNames()[static_cast<size_t>(pipeline.kind)];
  if (!pipeline.breaks.empty()) json["breaks"] = breaksJson(pipeline.breaks);
  if (!pipeline.compare_with.empty()) json["compare_with"] = pipeline.compare_with;
  if (!pipeline.equals.empty()) json["equals"] = listOf(pipeline.equals, equalJson);
  json["params"] = listOf(pipeline.params, paramJson);
  if (!pipeline.graph_params.empty()) json["graph_params"] = pipeline.graph_params;
  if (!pipeline.presets.empty()) json["presets"] = listOf(pipeline.presets, presetJson);
  if (!pipeline.preset.empty()) json["preset"] = pipeline.preset;
  json["values"] = valuesJson(pipeline.values);
  json["passes"] = listOf(pipeline.passes, [](const PassDesc& pass) { return toJson(pass); });
  json["nodes"] = listOf(pipeline.nodes, nodeJson);
  json["loops"] = listOf(pipeline.loops, loopJson);
  json["outputs"] = Json::object();
  for (const auto& [name, source] : pipeline.outputs) json["outputs"][name] = source;
  if (!pipeline.regions.empty()) json["regions"] = listOf(pipeline.regions, regionJson);
  return json;
}

}  // namespace strobe::plan
