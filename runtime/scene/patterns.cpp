// SPDX-License-Identifier: MIT
// The patterns of textures.h. Most repeat seamlessly over 0..1. Random values are hashes of integers.
#include <algorithm>
#include <cmath>
#include <map>

#include "math/constants.h"
#include "scene/textures.h"

namespace strobe::scene {

namespace {

double fraction(double x) { return x - std::floor(x); }

// Hash of two integers and a seed (PCG-like mixing), in 0..1.
double hash(int x, int y, int seed) {
  uint32_t h = uint32_t(x) * 0x8da6b343u ^ uint32_t(y) * 0xd8163841u ^ uint32_t(seed) * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return (h ^ (h >> 15)) / 4294967296.0;
}

// floor(x) without a call, because noise takes most of the time of painting.
int floored(double x) {
  int truncated = int(x);
  return truncated - (x < truncated);
}

// i modulo n, 0 to n - 1. Most values are in this range already.
int wrapped(int i, int n) {
  if (i >= 0 && i < n) return i;
  int rest = i % n;
  return rest < 0 ? rest + n : rest;
}

// Smooth noise in 0..1 that repeats after `period` cells.
double noise(dvec2 p, ivec2 period, int seed) {
  ivec2 cell(floored(p.x), floored(p.y));
  dvec2 t = p - dvec2(cell);
  t = t * t * (3.0 - 2.0 * t);
  ivec2 low(wrapped(cell.x, period.x), wrapped(cell.y, period.y));
  ivec2 high(low.x + 1 == period.x ? 0 : low.x + 1, low.y + 1 == period.y ? 0 : low.y + 1);
  auto at = [&](int dx, int dy) { return hash(dx ? high.x : low.x, dy ? high.y : low.y, seed); };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), t.x), glm::mix(at(0, 1), at(1, 1), t.x), t.y);
}

// Four octaves of noise, 0..1.
double turbulence(dvec2 uv, ivec2 cells, int seed) {
  double sum = 0, weight = 0.5;
  for (int octave = 0; octave < 4; ++octave, weight *= 0.5) {
    ivec2 period = cells * (1 << octave);
    sum += weight * noise(uv * dvec2(period), period, seed + octave);
  }
  return sum / 0.9375;
}

vec3 mixed(const vec3& a, const vec3& b, double t) { return glm::mix(a, b, float(std::clamp(t, 0.0, 1.0))); }

// 1 within `half_width` of 0, falling to 0 over a further tenth.
double stroke(double distance, double half_width) {
  return 1 - std::clamp((std::abs(distance) - half_width) / (0.1 * half_width + 1e-9), 0.0, 1.0);
}

vec3 stripes(const Pattern& p, dvec2 uv) {
  double total = 0;
  for (size_t i = 0; i < p.colors.size(); ++i) total += i < p.widths.size() ? p.widths[i] : 1;
  double at = fraction(uv.x * p.count.x) * total;
  for (size_t i = 0; i < p.colors.size(); ++i) {
    at -= i < p.widths.size() ? p.widths[i] : 1;
    if (at < 0) return p.colors[i];
  }
  return p.colors.back();
}

vec3 checker(const Pattern& p, dvec2 uv) {
  int parity = int(std::floor(uv.x * p.count.x)) + int(std::floor(uv.y * p.count.y));
  return p.colors[parity & 1];
}

// Diamonds with seams between them and a dot in each.
vec3 quilt(const Pattern& p, dvec2 uv) {
  dvec2 at = uv * p.count;
  dvec2 diagonal(fraction(at.x + at.y) - 0.5, fraction(at.x - at.y) - 0.5);
  double seam = 0.5 - std::max(std::abs(diagonal.x), std::abs(diagonal.y));
  double shade = 0.82 + 0.18 * std::min(1.0, seam * 5);
  double seam_line = stroke(seam, p.line * 0.5), dot = stroke(glm::length(diagonal), 0.13);
  return mixed(mixed(p.colors[0] * float(shade), p.colors[1], seam_line), p.colors[2], dot);
}

// A field of diamonds within two borders of zigzag, with a little wool.
// NOLINTBEGIN(bugprone-branch-clone): bands in their order
vec3 rug(const Pattern& p, dvec2 uv) {
  dvec2 inset = glm::min(uv, 1.0 - uv);
  double edge = std::min(inset.x * 1.5, inset.y);
  double along = inset.x * 1.5 < inset.y ? uv.y : uv.x;
  double wool = 0.86 + 0.14 * hash(int(uv.x * 400), int(uv.y * 300), p.seed);
  vec3 color = p.colors[0];
  double zigzag = std::abs(fraction(along * 18) - 0.5) * 0.05;
  if (edge < 0.022) color = p.colors[3];
  else if (edge < 0.085) color = edge - 0.03 > zigzag ? p.colors[1] : p.colors[2];
  else if (edge < 0.098) color = p.colors[3];
  else {
    dvec2 at = uv * dvec2(7, 5);
    double diamond = std::abs(fraction(at.x) - 0.5) + std::abs(fraction(at.y) - 0.5);
    if (diamond < 0.13) color = p.colors[3];
    else if (diamond < 0.3) color = p.colors[2];
    else if (diamond < 0.36) color = p.colors[3];
    else if (diamond > 0.86) color = p.colors[1];
  }
  return color * float(wool);
}
// NOLINTEND(bugprone-branch-clone)

vec3 wood(const Pattern& p, dvec2 uv) {
  int planks = std::max(1, int(p.count.x));
  int plank = int(std::floor(uv.x * planks));
  double across = fraction(uv.x * planks);
  double shift = hash(plank, 7, p.seed);
  double end = fraction(uv.y + shift);
  double grain = turbulence({uv.x, fraction(uv.y * 0.5 + shift)}, {planks * 10, 2}, p.seed);
  double rings = 0.5 + 0.5 * std::sin(2 * kPi * (across * 3 + 4 * grain + 2 * shift));
  double tone = 0.35 * shift + p.amount * (0.5 * grain + 0.25 * rings);
  vec3 color = mixed(p.colors[0], p.colors[1], tone);
  bool gap = planks > 1 && (across < p.line * 0.5 || end < p.line * 0.04);
  return gap ? color * 0.35f : color;
}

vec3 speckle(const Pattern& p, dvec2 uv) {
  double value = turbulence(uv, ivec2(glm::max(p.count, dvec2(1))), p.seed);
  return mixed(p.colors[0], p.colors[1], 0.5 + (value - 0.5) * 2 * p.amount);
}

vec3 weave(const Pattern& p, dvec2 uv) {
  dvec2 at = uv * p.count;
  bool over = (int(std::floor(at.x)) + int(std::floor(at.y))) & 1;
  double bow = over ? fraction(at.x) : fraction(at.y);
  return p.colors[over ? 0 : 1] * float(0.7 + 0.3 * std::sin(kPi * bow));
}

vec3 spine(const Pattern& p, dvec2 uv) {
  double band = 0.12 + 0.1 * hash(1, 1, p.seed);
  bool banded = std::abs(uv.y - band) < 0.02 || std::abs(uv.y - (1 - band)) < 0.02;
  if (banded) return p.colors[1];
  double title_top = 0.3, title_bottom = 0.55 + 0.15 * hash(2, 1, p.seed);
  bool letters = uv.y > title_top && uv.y < title_bottom && std::abs(uv.x - 0.5) < 0.16;
  if (letters && hash(int(uv.y * 40), 3, p.seed) > 0.4) return p.colors[2];
  return p.colors[0] * float(0.85 + 0.15 * turbulence(uv, {6, 6}, p.seed));
}

// Hills under a low sun.
vec3 painting(const Pattern& p, dvec2 uv) {
  vec3 color = mixed(p.colors[0], p.colors[1], 0.6 * uv.y * uv.y);
  if (glm::length((uv - dvec2(0.64, 0.36)) * dvec2(1.4, 1)) < 0.13) color = p.colors[1];
  auto ridge = [&](double base, double height, int cells, int salt) {
    return base - height * turbulence({uv.x, 0.5}, {cells, 1}, p.seed + salt);
  };
  if (uv.y > ridge(0.72, 0.3, 3, 10)) color = p.colors[2];
  if (uv.y > ridge(0.86, 0.28, 4, 20)) color = p.colors[3];
  if (uv.y > ridge(0.97, 0.2, 5, 30)) color = p.colors[4];
  return color * float(0.9 + 0.2 * (turbulence(uv, {40, 12}, p.seed + 40) - 0.5));
}

vec3 gradient(const Pattern& p, dvec2 uv) { return mixed(p.colors[0], p.colors[1], uv.y); }

vec3 leaf(const Pattern& p, dvec2 uv) {
  double from_rib = std::abs(fraction(uv.x * 2) - 0.5);
  double veins = stroke(fraction(uv.y * 9 + from_rib * 3) - 0.5, 0.06);
  return mixed(p.colors[0], p.colors[1], std::max(stroke(from_rib, 0.04), 0.5 * veins));
}

struct KnownPattern {
  size_t colors;
  vec3 (*color_at)(const Pattern&, dvec2);
};

const std::map<std::string, KnownPattern>& known() {
  static const std::map<std::string, KnownPattern> patterns = {
      {"stripes", {1, stripes}},   {"checker", {2, checker}},   {"quilt", {3, quilt}}, {"rug", {4, rug}},
      {"wood", {2, wood}},         {"noise", {2, speckle}},     {"weave", {2, weave}}, {"spine", {3, spine}},
      {"painting", {5, painting}}, {"gradient", {2, gradient}}, {"leaf", {2, leaf}}};
  return patterns;
}

}  // namespace

const std::vector<std::string>& patternNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const auto& [name, pattern] : known()) result.push_back(name);
    return result;
  }();
  return names;
}

size_t patternColors(const std::string& type) { return known().at(type).colors; }

Texture paintPattern(const Pattern& pattern) {
  const KnownPattern& painter = known().at(pattern.type);
  STROBE_ASSERT(pattern.colors.size() >= painter.colors, "{} {}", pattern.type, pattern.colors.size());
  Texture texture = paint(pattern.width, pattern.height, 2,
                          [&](dvec2 uv) { return vec4(glm::clamp(painter.color_at(pattern, uv), 0.0f, 1.0f), 1); });
  texture.name = pattern.type;
  return texture;
}

}  // namespace strobe::scene
