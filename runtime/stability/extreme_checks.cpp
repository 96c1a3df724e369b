// SPDX-License-Identifier: MIT
#include "stability/extreme_checks.h"

#include <algorithm>
#include <cmath>

#include "image/metrics.h"
#include "image/regions.h"

namespace strobe::stability::extreme {

using image::Image;
using lab::Shot;

// ---- shots

Shot shotOf(const std::string& scene, int width, int height, const std::vector<Setting>& settings) {
  Shot shot;
  shot.scene = scene;
  shot.width = width;
  shot.height = height;
  shot.frame = 0;
  shot.sets = {{"scene.width", std::to_string(width)}, {"scene.height", std::to_string(height)}};
  for (const Setting& setting : settings)
    shot.sets.push_back({fmt::format("scene.{}", setting.name), fmt::format("{}", setting.value)});
  return shot;
}

Shot set(Shot shot, const std::vector<std::pair<std::string, std::string>>& settings) {
  for (const auto& setting : settings) shot.sets.push_back(setting);
  return shot;
}

Shot anchored(Shot shot, const std::string& anchor) {
  shot.anchor = anchor;
  return shot;
}

// ---- pictures

const Image& colorIn(const lab::Picture& picture) { return picture.frame.outputs.at("color").floats; }
static const Image& velocityIn(const lab::Picture& picture) { return picture.frame.outputs.at("velocity").floats; }

static std::pair<float, float> rangeOf(const Image& color) {
  std::pair<float, float> range = {INFINITY, -INFINITY};
  for (size_t i = 0; i < color.values.size(); ++i)
    if (i % 4 != 3) range = {std::min(range.first, color.values[i]), std::max(range.second, color.values[i])};
  return range;
}

bool warnedOf(const lab::Picture& picture, const std::string& text) {
  return std::any_of(picture.warnings.begin(), picture.warnings.end(),
                     [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

// ---- what must hold

void expectSharp(Probe& probe, const Shot& shot) {
  int different = image::countDifferent(colorIn(probe.picture(shot)), colorIn(probe.sharp(shot)), 0);
  probe.expect(different == 0, fmt::format("{} pixels are not as the capture sees them", different));
}

// The same but for silhouettes that cross sample positions by rounding: 4 of 518400 pixels of a picture of few, and in
// proportion to their number.
void expectSharpBut(Probe& probe, const Shot& shot, int pixels) {
  int different = image::countDifferent(colorIn(probe.picture(shot)), colorIn(probe.sharp(shot)), 0);
  probe.expect(different <= pixels,
               fmt::format("{} pixels are not as the capture sees them, at most {} may", different, pixels));
}

void expectWithin(Probe& probe, const Shot& shot, double low, double high) {
  auto [least, most] = rangeOf(colorIn(probe.picture(shot)));
  double slack = 1e-5 * std::max(std::abs(low), std::abs(high));  // rounding of N weights, 2 ulp each
  bool inside = least >= low - slack && most <= high + slack;
  probe.expect(inside, fmt::format("colours from {} to {}, of surfaces from {} to {}", least, most, low, high));
}

void expectNearerToTruth(Probe& probe, const Shot& shot) {
  if (!probe.filters()) return;
  const Image &truth = colorIn(probe.truth(shot)), &sharp = colorIn(probe.sharp(shot));
  double own = image::rootMeanSquaredError(colorIn(probe.picture(shot)), truth),
         without = image::rootMeanSquaredError(sharp, truth);
  probe.expect(own < without, fmt::format("RMSE {:.5f} to truth, {:.5f} without blur", own, without));
}

void expectSame(Probe& probe, const Shot& shot, const Shot& other, double tolerance, double share) {
  const Image &a = colorIn(probe.picture(shot)), &b = colorIn(probe.picture(other));
  int different = image::countDifferent(a, b, tolerance), most = int(share * a.width * a.height);
  probe.expect(different <= most,
               fmt::format("{} pixels differ by more than {}, at most {} may", different, tolerance, most));
}

// The same within a share of the displacement too, for paths that reach thousands of pixels.
void expectPath(Probe& probe, const Shot& shot, const PathAt& right, double share, double tolerance_px) {
  const Image& velocity = velocityIn(probe.picture(shot));
  double worst = 1;
  std::string text;
  for (int y = 0; y < velocity.height; ++y)
    for (int x = 0; x < velocity.width; ++x) {
      dvec2 exact = right(x + 0.5, y + 0.5), own(velocity.at(x, y, 0), velocity.at(x, y, 1));
      double off = glm::length(own - exact) / (share * glm::length(exact) + tolerance_px);
      if (!(off > worst)) continue;
      worst = off;
      text = fmt::format("displacement at ({}, {}) is ({:.6g}, {:.6g}), exactly ({:.6g}, {:.6g})", x, y, own.x, own.y,
                         exact.x, exact.y);
    }
  probe.expect(text.empty(), text);
}

void expectTruth(Probe& probe, const Shot& shot, const ValueAt& right, double bound) {
  if (!probe.isTruth()) return;
  const Image& color = colorIn(probe.truth(shot));
  double worst = 0;
  std::string text;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      double off = std::abs(color.at(x, y, 0) - right(x, y));
      if (off <= worst) continue;
      worst = off;
      text =
          fmt::format("({}, {}) is {:.6f}, exactly {:.6f} within {:.6f}", x, y, color.at(x, y, 0), right(x, y), bound);
    }
  probe.expect(worst <= bound, text);
}

Shot room(const std::vector<Setting>& settings) {
  return set(shotOf("stability/extreme", 48, 32, settings), {{"limit", "10"}, {"tile", "8"}, {"samples", "16"}});
}

}  // namespace strobe::stability::extreme
