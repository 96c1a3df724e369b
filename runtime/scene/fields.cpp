// SPDX-License-Identifier: MIT
#include "scene/fields.h"

#include <algorithm>
#include <cmath>

namespace strobe::scene {

void Problems::add(const Place& place, const std::string& text) {
  lines_.push_back(place.file.empty() ? text : place.text() + ": " + text);
}

void Problems::throwIfAny() const {
  constexpr size_t kShown = 20;
  if (lines_.size() <= kShown) return strobe::throwIfAny(lines_);
  std::vector<std::string> shown(lines_.begin(), lines_.begin() + kShown);
  shown.push_back(fmt::format("... and {} more", lines_.size() - kShown));
  strobe::throwIfAny(shown);
}

Place placeOf(const Json& json, const Place& otherwise) {
  if (!json.is_object() || !json.contains("place")) return otherwise;
  const Json& place = json["place"];
  if (!place.is_object() || !place.contains("line") || !place["line"].is_number_integer()) return otherwise;
  Place result = otherwise;
  result.line = place["line"].get<int>();
  if (place.contains("file") && place["file"].is_string()) result.file = place["file"].get<std::string>();
  return result;
}

Fields::Fields(const Json& json, std::string what, const Place& outer, Problems& problems)
    : json_(json), what_(std::move(what)), place_(placeOf(json, outer)), problems_(problems) {
  bool empty_table = json.is_array() && json.empty();
  if (!json.is_object() && !empty_table) problem(fmt::format("expected a table, got {}", json.type_name()));
}

bool Fields::has(const std::string& key) const { return json_.is_object() && json_.contains(key); }

const Json* Fields::find(const std::string& key) {
  known_.insert(key);
  return has(key) ? &json_[key] : nullptr;
}

const Json* Fields::need(const std::string& key) {
  const Json* value = find(key);
  if (!value) problem(fmt::format("needs '{}'", key));
  return value;
}

bool Fields::inRange(const std::string& key, double value, double min, double max) {
  if (value >= min && value <= max) return true;
  if (value < min) problem(fmt::format("'{}' = {} is below min {}", key, value, min));
  else if (value > max) problem(fmt::format("'{}' = {} is above max {}", key, value, max));
  else problem(fmt::format("'{}' is not a finite number", key));
  return false;
}

double Fields::number(const std::string& key, std::optional<double> fallback, double min, double max) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or(min);
  if (!value->is_number()) {
    problem(fmt::format("'{}' is {}, not a number", key, value->type_name()));
    return fallback.value_or(min);
  }
  double number = value->get<double>();
  return inRange(key, number, min, max) ? number : fallback.value_or(min);
}

int Fields::integer(const std::string& key, std::optional<int> fallback, int min, int max) {
  double value = number(key, fallback ? std::optional<double>(*fallback) : std::nullopt, min, max);
  if (value != std::floor(value)) problem(fmt::format("'{}' = {} is not a whole number", key, value));
  return int(value);
}

bool Fields::boolean(const std::string& key, bool fallback) {
  const Json* value = find(key);
  if (!value) return fallback;
  if (!value->is_boolean()) problem(fmt::format("'{}' is {}, not true or false", key, value->type_name()));
  return value->is_boolean() ? value->get<bool>() : fallback;
}

std::string Fields::text(const std::string& key, std::optional<std::string> fallback) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or("");
  if (!value->is_string()) problem(fmt::format("'{}' is {}, not text", key, value->type_name()));
  return value->is_string() ? value->get<std::string>() : fallback.value_or("");
}

std::string Fields::choice(const std::string& key, const std::string& fallback,
                           const std::vector<std::string>& choices) {
  std::string value = text(key, fallback);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  problem(fmt::format("'{}' = '{}' is none of {}{}", key, value, fmt::join(choices, ", "), didYouMean(value, choices)));
  return fallback;
}

std::vector<double> Fields::listOf(const std::string& key, const Json& list, size_t least, size_t most, double min,
                                   double max) {
  std::string wanted = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  if (!list.is_array() || list.size() < least || list.size() > most) {
    std::string got = list.is_array() ? fmt::format("{}", list.size()) : list.type_name();
    problem(fmt::format("'{}' must be a list of {} numbers, got {}", key, wanted, got));
    return {};
  }
  std::vector<double> values;
  for (const Json& item : list) {
    if (!item.is_number()) {
      problem(fmt::format("'{}' has {} where a number is wanted", key, item.type_name()));
      return {};
    }
    if (!inRange(key, item.get<double>(), min, max)) return {};
    values.push_back(item.get<double>());
  }
  return values;
}

dvec2 Fields::vector2(const std::string& key, std::optional<dvec2> fallback, double min, double max) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or(dvec2(1));
  std::vector<double> v = listOf(key, *value, 2, 2, min, max);
  return v.empty() ? fallback.value_or(dvec2(1)) : dvec2(v[0], v[1]);
}

dvec3 Fields::vector3(const std::string& key, std::optional<dvec3> fallback, double min, double max) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or(dvec3(1));
  std::vector<double> v = listOf(key, *value, 3, 3, min, max);
  return v.empty() ? fallback.value_or(dvec3(1)) : dvec3(v[0], v[1], v[2]);
}

vec4 Fields::color(const std::string& key, std::optional<vec4> fallback, double max) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or(vec4(1));
  std::vector<double> v = listOf(key, *value, 3, 4, 0, max);
  if (v.empty()) return fallback.value_or(vec4(1));
  return vec4(v[0], v[1], v[2], v.size() == 4 ? v[3] : 1);
}

std::vector<std::vector<double>> Fields::rows(const std::string& key, size_t size, size_t least, size_t most,
                                              size_t size_max, double limit) {
  const Json* value = least > 0 ? need(key) : find(key);
  std::vector<std::vector<double>> result;
  if (!value) return result;
  if (!value->is_array() || value->size() < least || value->size() > most) {
    problem(fmt::format("'{}' must be a list of {} to {} lists", key, least, most));
    return result;
  }
  for (const Json& row : *value) {
    result.push_back(listOf(key, row, size, std::max(size, size_max), -limit, limit));
    if (result.back().empty()) return {};
  }
  return result;
}

std::vector<double> Fields::numbers(const std::string& key, size_t least, size_t most) {
  const Json* value = least > 0 ? need(key) : find(key);
  return value ? listOf(key, *value, least, most, -1e9, 1e9) : std::vector<double>();
}

void Fields::finish() {
  if (!json_.is_object()) return;
  std::vector<std::string> names(known_.begin(), known_.end());
  std::erase_if(names, [](const std::string& name) { return name == "kind" || name == "type" || name == "place"; });
  for (const auto& [key, value] : json_.items()) {
    if (known_.count(key)) continue;
    std::string near = didYouMean(key, names);
    if (near.empty()) near = fmt::format("; it has {}", fmt::join(names, ", "));
    problem(fmt::format("unknown key '{}'{}", key, near));
  }
}

}  // namespace strobe::scene
