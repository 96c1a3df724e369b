// SPDX-License-Identifier: MIT
#include "scene/key_search.h"

#include <algorithm>

#include "base/error.h"
#include "math/constants.h"

namespace strobe::scene {

namespace {

struct Parts {
  dvec3 translation;
  dquat rotation;
  dvec3 scale;
};

Parts partsOf(const dmat4& transform) {
  dmat3 axes(transform);
  dvec3 scale;
  for (int c = 0; c < 3; ++c) scale[c] = glm::length(axes[c]);
  if (glm::determinant(axes) < 0) scale = -scale;
  for (int c = 0; c < 3; ++c) axes[c] /= scale[c];
  return {dvec3(transform[3]), glm::quat_cast(axes), scale};
}

double angleBetween(const dmat4& a, const dmat4& b) {
  const double cosine = std::abs(glm::dot(partsOf(a).rotation, partsOf(b).rotation));
  return 2 * std::acos(std::min(cosine, 1.0));
}

// Transform between two others, `t` in [0, 1]. All have the form translation * rotation * scale.
dmat4 interpolated(const dmat4& a, const dmat4& b, double t) {
  const Parts from = partsOf(a), to = partsOf(b);
  dmat4 transform = glm::mat4_cast(glm::slerp(from.rotation, to.rotation, t));
  const dvec3 scale = glm::mix(from.scale, to.scale, t);
  for (int c = 0; c < 3; ++c) transform[c] *= scale[c];
  transform[3] = dvec4(glm::mix(from.translation, to.translation, t), 1);
  return transform;
}

// Every `step`-th transform of a path, and the largest deviation between them. The deviation is infinite if a rotation
// is too large.
Keys everyNth(const std::vector<dmat4>& path, size_t step,
              const std::function<double(size_t, const dmat4&)>& deviation) {
  Keys keys;
  for (size_t i = 0; i < path.size(); i += step) keys.transforms.push_back(path[i]);
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const dmat4 &before = path[i / step * step], &after = path[(i / step + 1) * step];
    if (step > 2 && angleBetween(before, after) > 5 * kPi / 180) return {{}, HUGE_VAL};
    const dmat4 between = interpolated(before, after, double(i % step) / double(step));
    keys.deviation = std::max(keys.deviation, deviation(i, between));
  }
  return keys;
}

}  // namespace

bool isSheared(const dmat4& transform) {
  const dvec3 x(transform[0]), y(transform[1]), z(transform[2]);
  auto slanted = [](const dvec3& a, const dvec3& b) {
    return std::abs(glm::dot(a, b)) > 1e-6 * glm::length(a) * glm::length(b);
  };
  return slanted(x, y) || slanted(y, z) || slanted(z, x);
}

Keys keysOf(const std::vector<dmat4>& path, double most_deviation,
            const std::function<double(size_t time, const dmat4&)>& deviation) {
  STROBE_ASSERT(path.size() == kPathTimes, "{}", path.size());
  if (std::all_of(path.begin(), path.end(), [&](const dmat4& one) { return one == path[0]; })) return {{path[0]}, 0};
  for (size_t step = path.size() - 1; step > 2; step /= 2)
    if (Keys keys = everyNth(path, step, deviation); keys.deviation <= most_deviation) return keys;
  return everyNth(path, 2, deviation);
}

}  // namespace strobe::scene
