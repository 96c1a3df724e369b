// SPDX-License-Identifier: MIT
#include "scene/flat.h"

#include <algorithm>
#include <cmath>

#include "scene/motion.h"

namespace strobe::scene {

namespace {

double normOf(const dmat3& m) { return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])); }

// Matrix of cofactors: the inverse, transposed, times the determinant.
dmat3 cofactorsOf(const dmat3& m) {
  return dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

dmat3 absoluteOf(const dmat3& m) { return dmat3(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])); }

// Upper bound of the growth of rounding errors when a point is transformed to object space and back: the norm of |M|
// |M^-1| (Skeel, "Scaling for Numerical Stability in Gaussian Elimination", 1979). Scales along the object's own axes
// do not count.
double roundingOf(const dmat3& m, const dmat3& cofactors, double determinant) {
  const dmat3 product = absoluteOf(m) * absoluteOf(glm::transpose(cofactors));
  double most = 0;
  for (int row = 0; row < 3; ++row) most = std::max(most, product[0][row] + product[1][row] + product[2][row]);
  return most / std::abs(determinant);
}

constexpr double kLine = 1e-10;         // share of the greatest area below which only a line or a point is left
constexpr double kSheet = 1e-6;         // thickness of a sheet, as a share of its width
constexpr double kMostRounding = 4096;  // a quarter of a pixel at 1000 px

// Values of a scale track, including the control points of the Bezier curves that enclose a cubic spline.
std::vector<dvec3> scalesOf(const Track& track) {
  std::vector<dvec3> scales;
  if (track.interpolation != Track::Interpolation::CubicSpline) {
    for (const dvec4& value : track.values) scales.push_back(dvec3(value));
    return scales;
  }
  for (size_t key = 0; key < track.times.size(); ++key) {
    const dvec3 value(track.values[3 * key + 1]);
    scales.push_back(value);
    if (key > 0)
      scales.push_back(value - dvec3(track.values[3 * key]) * (track.times[key] - track.times[key - 1]) / 3.0);
    if (key + 1 < track.times.size())
      scales.push_back(value + dvec3(track.values[3 * key + 2]) * (track.times[key + 1] - track.times[key]) / 3.0);
  }
  return scales;
}

dmat3 matrixOf(const dvec3& scale) { return dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z); }

// True if a mix of these scales may be flat. Scales of one shape shrink to a point instead.
bool mayFlatten(const std::vector<dvec3>& scales) {
  dvec3 low(HUGE_VAL), high(-HUGE_VAL), longest(0);
  for (const dvec3& scale : scales) {
    if (isFlat(matrixOf(scale))) return true;
    low = glm::min(low, scale), high = glm::max(high, scale);
    if (glm::length(scale) > glm::length(longest)) longest = scale;
  }
  const bool have_one_shape = std::all_of(scales.begin(), scales.end(), [&](const dvec3& scale) {
    return glm::length(glm::cross(scale, longest)) <= kSheet * glm::length(scale) * glm::length(longest);
  });
  const double least = kSheet * glm::length(longest);
  for (int axis = 0; axis < 3; ++axis)
    if (!have_one_shape && low[axis] <= least && high[axis] >= -least) return true;
  return false;
}

}  // namespace

bool isFlat(const dmat3& transform) {
  const dmat3 cofactors = cofactorsOf(transform);
  const double size = normOf(transform), area = normOf(cofactors);
  if (!(area > kLine * size * size) || !std::isfinite(area)) return false;
  const double determinant = glm::dot(transform[0], cofactors[0]);
  const double width = area / size;
  return std::abs(determinant) < kSheet * area * width || roundingOf(transform, cofactors, determinant) > kMostRounding;
}

std::vector<bool> flatteningNodes(const Scene& scene) {
  const std::vector<dmat4> worlds = restWorlds(scene);
  std::vector<bool> flattens;
  for (const dmat4& world : worlds) flattens.push_back(isFlat(dmat3(world)));
  for (const Animation& clip : scene.animations)
    for (const Track& track : clip.tracks)
      if (track.target == Track::Target::Scale && mayFlatten(scalesOf(track))) flattens[size_t(track.object)] = true;
  markDescendants(scene, flattens);
  return flattens;
}

}  // namespace strobe::scene
