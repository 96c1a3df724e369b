// SPDX-License-Identifier: MIT
#include "oracle/gather_2d.h"

#include <algorithm>
#include <cmath>

#include "oracle/gather_1d.h"

namespace strobe::oracle {
namespace {

double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
Vec2d scaled(Vec2d a, double s) { return {a.x * s, a.y * s}; }
double lengthOf(Vec2d a) { return std::hypot(a.x, a.y); }
Vec2d unitOf(Vec2d a) { return lengthOf(a) > 0 ? scaled(a, 1 / lengthOf(a)) : Vec2d{}; }

Vec2d vectorAt(const image::Image& image, int x, int y) { return {image.at(x, y, 0), image.at(x, y, 1)}; }

// 1 if b is as near as a or nearer, 0 if it is farther by `extent` of its depth.
double softShare(double a, double b, double extent) {
  return b <= a ? 1 : std::clamp(1 - (1 - a / b) / extent, 0., 1.);
}

double smooth(double t) { return t * t * (3 - 2 * t); }

struct Sample {
  Vec2d direction;
  double along;  // px, signed
};

}  // namespace

Vec2d secondDirection(Vec2d dominant, Vec2d own, Vec2d other, double radius, double gamma) {
  Vec2d across = unitOf({-dominant.y, dominant.x});
  double side = dot(across, own);
  if (std::abs(side) < 1.0 / 64) side = dot(across, other);
  if (std::abs(side) < 1.0 / 64) across = {};
  if (side < 0) across = scaled(across, -1);
  double share = std::clamp((radius - 0.5) / gamma, 0., 1.);
  Vec2d direction = unitOf(own);
  return unitOf({across.x * (1 - share) + direction.x * share, across.y * (1 - share) + direction.y * share});
}

double guertinAt(const Plane& plane, int x, int y, const PlaneGuertin& options) {
  int tile_x = x / plane.tile, tile_y = y / plane.tile, n = options.samples;
  Vec2d dominant = vectorAt(*plane.dominant, tile_x, tile_y);
  bool centred = options.window.open < 0 && options.window.close > 0, after = options.window.open >= 0;
  double share = centred ? 0.5 : 1, reach = lengthOf(dominant) * share;
  if (reach <= 0.505) return plane.color->at(x, y, 0);

  auto spread = [&](Vec2d d) { return std::max(lengthOf(d) * share, 0.5); };
  Vec2d own = vectorAt(*plane.velocity, x, y);
  double radius = spread(own), z = plane.depth->at(x, y, 0);
  Vec2d v_c = secondDirection(dominant, own, vectorAt(*plane.second, tile_x, tile_y), radius, options.gamma);
  int across = n / 2;
  if (plane.variance) {
    double t = std::clamp(plane.variance->at(tile_x, tile_y, 0) / 0.5, 0., 1.);
    across = int(std::floor(n / 2. * smooth(t) + 0.5));
  }

  double weight = n / (options.kappa * radius), sum = weight * plane.color->at(x, y, 0);
  for (int i = 0; i < n; ++i) {
    // One-sided samples are counted from the pixel outwards. Every n/across-th sample, from the middle of the first
    // group on, takes the second direction.
    int half = (n - 1) / 2;
    bool second = ((i + 1) * across + half) / n != (i * across + half) / n;
    Vec2d direction = second ? v_c : unitOf(dominant);
    if (lengthOf(direction) == 0) continue;
    double t = -1 + 2 * (i + (after ? -1 : 1) * options.eta * options.jitter + 1) / (n + 1);
    double along = centred ? t * reach : (t + 1) / 2 * reach * (after ? -1 : 1);
    int tap_x = std::clamp(tapAt(x, along * direction.x), 0, plane.color->width - 1);
    int tap_y = std::clamp(tapAt(y, along * direction.y), 0, plane.color->height - 1);

    Vec2d tap_d = vectorAt(*plane.velocity, tap_x, tap_y);
    double tap_radius = spread(tap_d), tap_z = plane.depth->at(tap_x, tap_y, 0), distance = std::abs(along);
    double w_a = std::abs(dot(v_c, direction)), w_b = std::abs(dot(unitOf(tap_d), direction));
    double w = softShare(z, tap_z, options.depth_extent) * cone(distance, tap_radius) * w_b +
               softShare(tap_z, z, options.depth_extent) * cone(distance, radius) * w_a +
               2 * cylinder(distance, std::min(radius, tap_radius)) * std::max(w_a, w_b);
    weight += w;
    sum += w * plane.color->at(tap_x, tap_y, 0);
  }
  return sum / weight;
}

}  // namespace strobe::oracle
