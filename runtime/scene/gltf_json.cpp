// SPDX-License-Identifier: MIT
#include "scene/gltf_json.h"

#include <cmath>

#include "scene/motion.h"

namespace strobe::scene {

namespace {

const Json kNoList = Json::array();
const Json kNoObject = Json::object();

// Whole number, including forms such as "4.0" and "4e0".
std::optional<uint64_t> wholeNumber(const Json& json) {
  if (json.is_number_unsigned()) return json.get<uint64_t>();
  if (!json.is_number_float()) return std::nullopt;
  const double value = json.get<double>();
  const bool whole = value >= 0 && value < 9007199254740992.0 && value == std::floor(value);  // exact below 2^53
  return whole ? std::optional(uint64_t(value)) : std::nullopt;
}

}  // namespace

void GltfJson::refuse(const std::string& where, const std::string& text) const {
  throw Error(where.empty() ? text : where + ": " + text, {shown_.string()});
}

const Json& GltfJson::list(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return kNoList;
  if (!object[key].is_array()) refuse(where, fmt::format("'{}' is not a list", key));
  return object[key];
}

const Json& GltfJson::object(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return kNoObject;
  if (!object[key].is_object()) refuse(where, fmt::format("'{}' is not an object", key));
  return object[key];
}

const Json& GltfJson::extension(const Json& json, const std::string& name, bool* present) const {
  const Json& extensions = object(json, "extensions", "");
  if (present) *present = extensions.contains(name);
  return object(extensions, name, "extensions");
}

int GltfJson::index(const Json& object, const std::string& key, const std::string& list_name,
                    const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return -1;
  const Json& value = object[key];
  size_t count = all(list_name).size();
  const std::optional<uint64_t> whole = wholeNumber(value);
  std::string got = value.is_number() ? value.dump() : value.type_name();
  if (!whole || *whole >= count)
    refuse(where, fmt::format("'{}' is {}, but the file has {} {}", key, got, count, list_name));
  return int(*whole);
}

std::vector<int> GltfJson::indexList(const Json& object, const std::string& key, const std::string& list_name,
                                     const std::string& where) const {
  std::vector<int> indices;
  for (const Json& value : list(object, key, where)) indices.push_back(index({{key, value}}, key, list_name, where));
  return indices;
}

double GltfJson::number(const Json& object, const std::string& key, double fallback, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return fallback;
  if (!object[key].is_number()) refuse(where, fmt::format("'{}' is not a number", key));
  double value = object[key].get<double>();
  if (!std::isfinite(value)) refuse(where, fmt::format("'{}' is not finite", key));
  return value;
}

std::vector<double> GltfJson::numbers(const Json& object, const std::string& key, std::vector<double> fallback,
                                      const std::string& where) const {
  const Json& values = list(object, key, where);
  if (values.empty()) return fallback;
  if (values.size() != fallback.size())
    refuse(where, fmt::format("'{}' does not have {} numbers", key, fallback.size()));
  for (size_t i = 0; i < values.size(); ++i) {
    bool finite = values[i].is_number() && std::isfinite(values[i].get<double>());
    if (!finite) refuse(where, fmt::format("'{}' has an element that is not a finite number", key));
    fallback[i] = values[i].get<double>();
  }
  return fallback;
}

double GltfJson::numberIn(const Json& object, const std::string& key, std::optional<double> fallback, double low,
                          double high, const std::string& where) const {
  if (!fallback) require(object, key, where);
  if (!object.contains(key)) return *fallback;
  double value = number(object, key, 0, where);
  if (value < low || value > high) refuse(where, fmt::format("'{}' is {}, not from {} to {}", key, value, low, high));
  return value;
}

void GltfJson::require(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.contains(key)) refuse(where, fmt::format("'{}' is missing", key));
}

std::string GltfJson::text(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return "";
  if (!object[key].is_string()) refuse(where, fmt::format("'{}' is not a text", key));
  return object[key].get<std::string>();
}

std::vector<std::string> GltfJson::uniqueNames(const Json& list, const std::string& prefix,
                                               std::set<std::string> reserved) const {
  std::vector<std::string> names;
  std::set<std::string> taken = reserved, stated = std::move(reserved);
  for (const Json& object : list) stated.insert(text(object, "name"));
  auto claim = [&](const std::string& name, bool is_stated) {
    return is_stated == stated.contains(name) && taken.insert(name).second;
  };
  for (const Json& object : list) {
    const std::string own = text(object, "name");
    const std::string base = own.empty() ? fmt::format("{}_{}", prefix, names.size()) : own;
    std::string name = base;
    bool is_free = claim(name, !own.empty());
    for (int i = 2; !is_free; ++i) {
      name = fmt::format("{}#{}", base, i);
      is_free = claim(name, false);
    }
    names.push_back(name);
  }
  return names;
}

bool GltfJson::flag(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return false;
  if (!object[key].is_boolean()) refuse(where, fmt::format("'{}' is neither true nor false", key));
  return object[key].get<bool>();
}

size_t GltfJson::size(const Json& object, const std::string& key, std::optional<size_t> fallback,
                      const std::string& where) const {
  bool present = object.is_object() && object.contains(key);
  if (!present && fallback) return *fallback;
  if (!present) refuse(where, fmt::format("'{}' is missing", key));
  const std::optional<uint64_t> value = wholeNumber(object[key]);
  if (!value) refuse(where, fmt::format("'{}' is not a whole number", key));
  if (*value > uint64_t(1) << 40) refuse(where, fmt::format("'{}' is {}, above the limit of 2^40", key, *value));
  return size_t(*value);
}

std::vector<double> cutsOf(const GltfJson& file, const Json& object, const std::string& where) {
  if (!object.is_object() || !object.contains("extras")) return {};
  const Json& extras = object["extras"];
  const std::string place = where + ".extras";
  const std::vector<double> none(file.list(extras, "cuts", place).size());
  std::vector<double> cuts = file.numbers(extras, "cuts", none, place);
  if (!increase(cuts)) file.refuse(place, "'cuts' do not increase");
  return cuts;
}

}  // namespace strobe::scene
