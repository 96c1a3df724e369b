// SPDX-License-Identifier: MIT
#include "base/strict.h"

#include <algorithm>
#include <cmath>

#include "base/json.h"

namespace strobe {

void Problems::add(const Place& place, const std::string& text) {
  if (when_ == When::at_once) throw Error(text, place);
  std::string line = place.file.empty() ? text : place.text() + ": " + text;
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(std::move(line));
}

void Problems::throwIfAny() const {
  constexpr size_t kShown = 20;
  if (lines_.size() <= kShown) return strobe::throwIfAny(lines_);
  std::vector<std::string> shown(lines_.begin(), lines_.begin() + kShown);
  shown.push_back(fmt::format("... and {} more", lines_.size() - kShown));
  strobe::throwIfAny(shown);
}

static bool isPlace(const Json& place) {
  if (!place.is_object() || !place.contains("line") || !place["line"].is_number_integer()) return false;
  bool in_range = place["line"].get<int64_t>() >= 0 && place["line"].get<int64_t>() <= 1 << 30;
  return in_range && (!place.contains("file") || place["file"].is_string());
}

Place placeOf(const Json& json, const Place& otherwise) {
  if (!json.is_object() || !json.contains("place") || !isPlace(json["place"])) return otherwise;
  const Json& place = json["place"];
  return {place.contains("file") ? place["file"].get<std::string>() : otherwise.file, place["line"].get<int>()};
}

Fields::Fields(const Json& json, std::string what, const Place& outer, Problems& problems)
    : json_(json), what_(std::move(what)), place_(placeOf(json, outer)), problems_(problems) {
  bool empty_table = json.is_array() && json.empty();
  if (!json.is_object() && !empty_table) problem(fmt::format("expected a table, got {}", json.type_name()));
  if (has("place") && !isPlace(json["place"])) problem("'place' is not a file and a line");
}

bool Fields::has(const std::string& key) {
  if (!allowed_.count(key)) known_.insert(key);
  return json_.is_object() && json_.contains(key);
}

const Json* Fields::find(const std::string& key) { return has(key) ? &json_[key] : nullptr; }

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

std::string Fields::text(const std::string& key, const std::optional<std::string>& fallback) {
  const Json* value = fallback ? find(key) : need(key);
  if (!value) return fallback.value_or("");
  if (!value->is_string()) problem(fmt::format("'{}' is {}, not text", key, value->type_name()));
  return value->is_string() ? value->get<std::string>() : fallback.value_or("");
}

std::string Fields::choice(const std::string& key, const std::optional<std::string>& fallback,
                           const std::vector<std::string>& choices) {
  std::string value = text(key, fallback);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  problem(
      fmt::format("'{}' = '{}' is not one of {}{}", key, value, fmt::join(choices, ", "), didYouMean(value, choices)));
  return fallback.value_or(choices.front());
}

const Json& Fields::collection(const std::string& key, bool is_list, size_t most) {
  static const Json no_list = Json::array(), no_table = Json::object();
  const Json& none = is_list ? no_list : no_table;
  const Json* value = find(key);
  if (!value || (value->is_structured() && value->empty())) return none;
  bool right = is_list ? value->is_array() : value->is_object();
  if (!right) problem(fmt::format("'{}' is {}, not a {}", key, value->type_name(), is_list ? "list" : "table"));
  if (right && value->size() > most)
    problem(fmt::format("'{}' has {} entries; the maximum is {}", key, value->size(), most));
  return right && value->size() <= most ? *value : none;
}

const Json& Fields::list(const std::string& key, size_t most) { return collection(key, true, most); }
const Json& Fields::table(const std::string& key, size_t most) { return collection(key, false, most); }

std::vector<std::string> Fields::texts(const std::string& key) {
  std::vector<std::string> result;
  for (const Json& item : list(key)) {
    if (!item.is_string()) problem(fmt::format("'{}' has {} where a text is expected", key, item.type_name()));
    else result.push_back(item.get<std::string>());
  }
  return result;
}

std::vector<double> Fields::listOf(const std::string& key, const Json& list, size_t least, size_t most, double min,
                                   double max) {
  std::string expected = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  if (!list.is_array() || list.size() < least || list.size() > most) {
    std::string got = list.is_array() ? fmt::format("{}", list.size()) : list.type_name();
    problem(fmt::format("'{}' must be a list of {} numbers, got {}", key, expected, got));
    return {};
  }
  std::vector<double> values;
  for (const Json& item : list) {
    if (!item.is_number()) {
      problem(fmt::format("'{}' has {} where a number is expected", key, item.type_name()));
      return {};
    }
    if (!inRange(key, item.get<double>(), min, max)) return {};
    values.push_back(item.get<double>());
  }
  return values;
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
  for (const auto& [key, value] : json_.items()) {
    if (known_.count(key) || allowed_.count(key)) continue;
    std::string near = didYouMean(key, names);
    if (near.empty()) near = fmt::format("; it has {}", fmt::join(names, ", "));
    problem(fmt::format("unknown key '{}'{}", key, near));
  }
}

}  // namespace strobe
