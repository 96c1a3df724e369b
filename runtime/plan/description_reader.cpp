// SPDX-License-Identifier: MIT
#include "plan/description_reader.h"

#include <fmt/format.h>

#include "base/json.h"
#include "base/lists.h"

namespace strobe::plan {

Problems& Reader::thrownAtOnce() {
  static Problems problems(Problems::When::at_once);
  return problems;
}

bool isName(const std::string& name) {
  bool starts = !name.empty() && name.size() <= 64 && name[0] >= 'a' && name[0] <= 'z';
  return starts && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

bool isPath(const std::string& name) {
  for (size_t start = 0;;) {
    size_t slash = name.find('/', start);
    if (!isName(name.substr(start, slash - start))) return false;
    if (slash == std::string::npos) return true;
    start = slash + 1;
  }
}

std::string nameOf(Reader& reader) {
  std::string name = reader.text("name", std::nullopt);
  if (!isName(name)) reader.fail(fmt::format("'{}' is not a name (a-z, then a-z, 0-9 and _)", name));
  return name;
}

Breaks breaksOf(const Reader& reader, const Json& json) {
  if (!json.is_object()) reader.fail("'breaks' is not a table of invariants");
  Breaks breaks;
  for (const auto& [invariant, reason] : json.items()) {
    const auto& known = invariantNames();
    if (!contains(known, invariant))
      reader.fail(fmt::format("unknown invariant '{}'{}", invariant, didYouMean(invariant, known)));
    if (!reason.is_string()) reader.fail(fmt::format("the reason that '{}' is broken is not a text", invariant));
    breaks.emplace_back(invariant, reason.get<std::string>());
  }
  return breaks;
}

std::vector<std::pair<std::string, std::string>> textsByName(Reader& reader, const char* key) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [name, text] : reader.table(key).items()) {
    if (!text.is_string()) reader.fail(fmt::format("'{}' of '{}' is not a text", name, key));
    texts.emplace_back(name, text.get<std::string>());
  }
  return texts;
}

// Broken invariants per value of a parameter.
static std::vector<std::pair<std::string, Breaks>> valueBreaks(Reader& reader, const ParamDesc& param) {
  std::vector<std::pair<std::string, Breaks>> result;
  if (!reader.has("breaks")) return result;
  for (const auto& [value, breaks] : reader.table("breaks").items()) {
    bool is_number = param.type == ParamDesc::Type::Int || param.type == ParamDesc::Type::Float;
    if (is_number && value != kOtherNumbers)
      reader.fail(fmt::format("'breaks' of the number '{}' has the key '{}' instead of '{}'", param.name, value,
                              kOtherNumbers));
    if (!is_number) checkValue(param, Value(value), param.place);
    result.emplace_back(value, breaksOf(reader, breaks));
  }
  return result;
}

ParamDesc readParam(const Json& json) {
  Reader reader(json, "parameter");
  ParamDesc param;
  param.place = reader.place();
  param.name = nameOf(reader);
  param.type = static_cast<ParamDesc::Type>(reader.oneOf("type", kParamTypes));
  param.min = reader.number("min");
  param.max = reader.number("max");
  bool crossed = param.min && param.max && *param.min > *param.max;
  if (crossed) reader.fail(fmt::format("min of '{}' is above max", param.name));
  param.choices = reader.texts("choices");
  param.values = textsByName(reader, "values");
  param.unit = reader.text("unit");
  param.doc = reader.text("doc");
  if (reader.has("role")) param.role = static_cast<Role>(reader.oneOf("role", roleNames()) + 1);
  param.has_auto = reader.boolean("auto", false);
  bool may_have = param.type == ParamDesc::Type::Float && param.min && *param.min > kAuto;
  if (param.has_auto && !may_have)
    reader.fail(fmt::format("'auto' of '{}' needs a float that is never negative", param.name));
  bool is_range = param.type == ParamDesc::Type::Float && param.min && param.max && !param.has_auto;
  if (param.role == Role::Quality && !is_range)
    reader.fail(fmt::format("'{}' has the role 'quality', which needs a float with a range", param.name));
  param.wired = reader.boolean("wired", false);
  param.variant = reader.boolean("variant", false);
  param.variant = isCompiledIn(param);
  param.breaks = valueBreaks(reader, param);
  param.default_value = checkValue(param, valueFromJson(reader.at("default")), param.place);
  reader.finish();
  return param;
}

}  // namespace strobe::plan
