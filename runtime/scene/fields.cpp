// SPDX-License-Identifier: MIT
#include "scene/fields.h"

namespace strobe::scene {

std::vector<double> SceneFields::listAt(const std::string& key, bool needed, size_t least, size_t most, double min,
                                        double max) {
  const Json* value = needed ? need(key) : find(key);
  return value ? listOf(key, *value, least, most, min, max) : std::vector<double>();
}

dvec2 SceneFields::vector2(const std::string& key, std::optional<dvec2> fallback, double min, double max) {
  std::vector<double> v = listAt(key, !fallback, 2, 2, min, max);
  return v.empty() ? fallback.value_or(dvec2(1)) : dvec2(v[0], v[1]);
}

dvec3 SceneFields::vector3(const std::string& key, std::optional<dvec3> fallback, double min, double max) {
  std::vector<double> v = listAt(key, !fallback, 3, 3, min, max);
  return v.empty() ? fallback.value_or(dvec3(1)) : dvec3(v[0], v[1], v[2]);
}

vec4 SceneFields::color(const std::string& key, std::optional<vec4> fallback, double max) {
  std::vector<double> v = listAt(key, !fallback, 3, 4, 0, max);
  if (v.empty()) return fallback.value_or(vec4(1));
  return vec4(v[0], v[1], v[2], v.size() == 4 ? v[3] : 1);
}

}  // namespace strobe::scene
