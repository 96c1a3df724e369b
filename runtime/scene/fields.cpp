// SPDX-License-Identifier: MIT
#include "scene/fields.h"

namespace strobe::scene {

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

}  // namespace strobe::scene
