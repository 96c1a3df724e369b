// SPDX-License-Identifier: MIT
#include "plan/description.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/json.h"
#include "base/lists.h"
#include "plan/formats.h"
#include "plan/named.h"

namespace strobe::plan {

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

// ---- look-up in a pipeline

const ParamDesc* paramNamed(const PipelineDesc& pipeline, const std::string& name) {
  return find(pipeline.params, name);
}

const ParamDesc* paramOf(const PipelineDesc& pipeline, Role role) {
  auto found =
      std::find_if(pipeline.params.begin(), pipeline.params.end(), [&](const auto& p) { return p.role == role; });
  return found == pipeline.params.end() ? nullptr : &*found;
}

const Value* valueOf(const PipelineDesc& pipeline, const std::string& name) { return valueIn(pipeline.values, name); }

const Value* valueOf(const PipelineDesc& pipeline, const Binding& binding) {
  return binding.value ? &*binding.value : valueOf(pipeline, binding.follows);
}

// The integer of a binding; `otherwise` if its value does not follow from the parameters of the pipeline.
static int64_t wholeOf(const PipelineDesc& pipeline, const Binding& binding, int64_t otherwise) {
  const Value* value = valueOf(pipeline, binding);
  const int64_t* number = value ? std::get_if<int64_t>(value) : nullptr;
  return number ? *number : otherwise;
}

static bool hasTimes(const PipelineDesc& pipeline, const LoopDesc& loop, const char* wanted) {
  const Value* times = valueOf(pipeline, loop.times);
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

// The value in a message.
static std::string shown(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("'{}'", *text);
  const auto* number = std::get_if<double>(&value);
  return number ? fmt::format("{}", *number) : textOf(value);
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

static Value checkChoice(const ParamDesc& param, const Value& value, const Place& where) {
  // The name of a choice may be "2" or "true".
  std::string name = textOf(value);
  if (contains(param.choices, name)) return name;
  std::string near = std::holds_alternative<std::string>(value) ? didYouMean(name, param.choices) : "";
  throw Error(
      fmt::format("'{}' = {} is not one of {}{}", param.name, shown(value), fmt::join(param.choices, ", "), near),
      where);
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

// ---- ports

std::vector<std::string> outputsOf(const PassDesc& pass) {
  std::vector<std::string> names = namesOf(pass.writes), updates = namesOf(pass.updates);
  names.insert(names.end(), updates.begin(), updates.end());
  return names;
}

bool hasAbsent(const PortDesc& read) { return !read.absent.empty() || !read.absent_read.empty(); }

bool isCleared(const PortDesc& port) { return port.cleared || isBuffer(port.format); }

const std::string& formatOf(const PortDesc& port, const std::vector<std::pair<std::string, Value>>& params) {
  const Value* by = port.format_by.empty() ? nullptr : valueIn(params, port.format_by);
  const std::string* choice = by ? std::get_if<std::string>(by) : nullptr;
  const std::string* format = choice ? valueIn(port.formats, *choice) : nullptr;
  return format ? *format : port.format;
}

}  // namespace strobe::plan
