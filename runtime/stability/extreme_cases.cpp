// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "stability/extremes.h"
#include "stability/pictures.h"

namespace strobe::stability {

namespace {

using image::Image;
using lab::Shot;

// ---- shots

struct Setting {
  const char* name;
  double value;
};

Shot shotOf(const std::string& scene, int width, int height, const std::vector<Setting>& settings = {}) {
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

// With settings of the pipelines that have them.
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
const Image& velocityIn(const lab::Picture& picture) { return picture.frame.outputs.at("velocity").floats; }

std::pair<float, float> rangeOf(const Image& color) {
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

// Bit for bit what the capture sees.
void expectSharp(Probe& probe, const Shot& shot) {
  int different = countDifferent(colorIn(probe.picture(shot)), colorIn(probe.sharp(shot)), 0);
  probe.expect(different == 0, fmt::format("{} pixels are not as the capture sees them", different));
}

// The same but for silhouettes that cross sample positions by rounding: 4 of 518400 pixels of a picture of few, and in
// proportion to their number.
void expectSharpBut(Probe& probe, const Shot& shot, int pixels) {
  int different = countDifferent(colorIn(probe.picture(shot)), colorIn(probe.sharp(shot)), 0);
  probe.expect(different <= pixels, fmt::format("{} pixels are not as the capture sees them, at most {} may", different, pixels));
}

// Weights are not negative and add up to 1: nothing leaves the range of what there is to see.
void expectWithin(Probe& probe, const Shot& shot, double low, double high) {
  auto [least, most] = rangeOf(colorIn(probe.picture(shot)));
  double slack = 1e-5 * std::max(std::abs(low), std::abs(high));  // rounding of N weights, 2 ulp each
  bool inside = least >= low - slack && most <= high + slack;
  probe.expect(inside, fmt::format("colours from {} to {}, of surfaces from {} to {}", least, most, low, high));
}

// A filter is worth its name where it brings the picture nearer to truth.
void expectNearerToTruth(Probe& probe, const Shot& shot) {
  if (!probe.filters()) return;
  const Image &truth = colorIn(probe.truth(shot)), &sharp = colorIn(probe.sharp(shot));
  double own = rmsDifference(colorIn(probe.picture(shot)), truth), without = rmsDifference(sharp, truth);
  probe.expect(own < without, fmt::format("RMSE {:.5f} to truth, {:.5f} without blur", own, without));
}

// The other shot shows the same: at most `share` of the pixels may differ by more than `tolerance`.
void expectSame(Probe& probe, const Shot& shot, const Shot& other, double tolerance, double share) {
  const Image &a = colorIn(probe.picture(shot)), &b = colorIn(probe.picture(other));
  int different = countDifferent(a, b, tolerance), most = int(share * a.width * a.height);
  probe.expect(different <= most, fmt::format("{} pixels differ by more than {}, at most {} may", different, tolerance, most));
}

// The displacement image against its closed form, px; pixels at which that says nothing (NaN) are left out.
using PathAt = std::function<dvec2(double x, double y)>;
void expectVelocity(Probe& probe, const Shot& shot, const PathAt& right, double tolerance_px) {
  const Image& velocity = velocityIn(probe.picture(shot));
  double worst = 0;
  std::string text;
  for (int y = 0; y < velocity.height; ++y)
    for (int x = 0; x < velocity.width; ++x) {
      dvec2 exact = right(x + 0.5, y + 0.5), own(velocity.at(x, y, 0), velocity.at(x, y, 1));
      double off = glm::length(own - exact);
      if (!(off > worst)) continue;
      worst = off;
      text = fmt::format("displacement at ({}, {}) is ({:.6g}, {:.6g}), exactly ({:.6g}, {:.6g})", x, y, own.x, own.y,
                         exact.x, exact.y);
    }
  probe.expect(worst <= tolerance_px, text);
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

// Truth's red channel against a closed form, with the bound of its midpoint times.
using ValueAt = std::function<double(int x, int y)>;
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
      text = fmt::format("({}, {}) is {:.6f}, exactly {:.6f} within {:.6f}", x, y, color.at(x, y, 0), right(x, y), bound);
    }
  probe.expect(worst <= bound, text);
}

// ---- a bar over a background at rest

constexpr int kBarWidth = 48, kBarHeight = 4;
constexpr double kBar = 1, kBack = 0.2;

Shot barShot(double displacement, double left = 16, double right = 32, int width = kBarWidth, int height = kBarHeight) {
  return shotOf("oracles/bar", width, height,
                {{"left", left}, {"right", right}, {"d_f", displacement}, {"foreground", kBar}, {"background", kBack}});
}

// Share of the window [from, to] (exposures from the capture) for which a bar [left, right) that moves by `d` px covers x.
double coverage(double left, double right, double d, double from, double to, double x) {
  if (d == 0) return x >= left && x < right;
  double a = (x - left) / d, b = (x - right) / d;  // it is at x between these times
  return std::max(0.0, std::min(to, std::max(a, b)) - std::max(from, std::min(a, b))) / (to - from);
}

// Two silhouettes of a jump of 0.8, each half a time sample off at most (D8).
constexpr double kBarBound = 2 * (kBar - kBack) / (2 * kTruthTimes) + 1e-4;

void checkBar(Probe& probe, double displacement, double left = 16, double right = 32) {
  Shot shot = set(barShot(displacement, left, right), {{"limit", "10"}, {"tile", "8"}});
  expectTruth(probe, shot, [&](int x, int) {
    return kBack + (kBar - kBack) * coverage(left, right, displacement, -1, 0, x + 0.5);
  }, kBarBound);
  expectWithin(probe, shot, kBack, kBar);
}

void addDisplacements(std::vector<Extreme>& list) {
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"zero", 0}, {"1e_8", 1e-8}, {"0_49", 0.49}, {"half", 0.5}, {"minus_half", -0.5}})
    list.push_back({fmt::format("displacement_{}_px", name), "displacement", "half a pixel reaches no other centre: copied, bit for bit",
                    [d = d](Probe& probe) { expectSharp(probe, set(barShot(d), {{"limit", "10"}})); }});
  for (const char* anchor : {"close", "centre", "open"})
    list.push_back({fmt::format("displacement_0_51_px_{}", anchor), "displacement", "colours stay between those of bar and background",
                    [anchor](Probe& probe) {
                      expectWithin(probe, anchored(set(barShot(0.51), {{"limit", "10"}}), anchor), kBack, kBar);
                    }});
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"tile", 8}, {"minus_tile", -8}, {"two_tiles", 16}, {"picture", 48}})
    list.push_back({fmt::format("displacement_one_{}", name), "displacement", "truth is the exact coverage; every blur is nearer to it than none",
                    [d = d](Probe& probe) {
                      checkBar(probe, d);
                      expectNearerToTruth(probe, set(barShot(d), {{"limit", "10"}, {"tile", "8"}}));
                    }});
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"ten_pictures", 480}, {"1e7_px", 1e7}, {"minus_1e7_px", -1e7}})
    list.push_back({fmt::format("displacement_{}", name), "displacement", "truth is the exact coverage; filters stay between the colours",
                    [d = d](Probe& probe) { checkBar(probe, d); }});
  for (auto [name, left, d] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"enters", -4, 24}, {"has_entered", 8, 24}, {"has_left", -24, -24}, {"passes_by", 60, 160}})
    list.push_back({fmt::format("object_{}", name), "displacement", "truth knows what was outside of the picture; filters stay between the colours",
                    [left = left, d = d](Probe& probe) { checkBar(probe, d, left, left + 16); }});
  for (auto [name, left, right] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"one_pixel", 24, 25}, {"a_tenth_of_a_pixel", 24.45, 24.55}})
    list.push_back({fmt::format("bar_of_{}", name), "displacement", "thinner than its path: truth is w/d",
                    [left = left, right = right](Probe& probe) { checkBar(probe, 12, left, right); }});
  list.push_back({"displacement_over_the_limit", "displacement", "what is shortened is counted; truth is not",
                  [](Probe& probe) {
                    Shot shot = set(barShot(40), {{"limit", "0.1"}, {"tile", "8"}});
                    expectWithin(probe, shot, kBack, kBar);
                    bool said = warnedOf(probe.picture(shot), "farther than the limit");
                    probe.expect(said == probe.filters(), said ? "truth was shortened" : "not said");
                    expectTruth(probe, shot, [](int x, int) {
                      return kBack + (kBar - kBack) * coverage(16, 32, 40, -1, 0, x + 0.5);
                    }, kBarBound);
                  }});
  for (auto [name, x, y] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"diagonal", 8, 8}, {"diagonal_back", -8, 8}, {"steep", 3, -17}, {"far_diagonal", 34, 34}})
    list.push_back({fmt::format("displacement_{}", name), "displacement", "every blur is nearer to truth than none",
                    [x = x, y = y](Probe& probe) {
                      Shot shot = shotOf("oracles/quad_2d", 48, 48, {{"left", 16}, {"right", 32}, {"top", 16}, {"bottom", 32}, {"d_x", x}, {"d_y", y}});
                      shot = set(shot, {{"limit", "2"}, {"tile", "8"}});
                      expectWithin(probe, shot, 0.1, 0.9);
                      expectNearerToTruth(probe, shot);
                    }});
}

// ---- sizes

void addSizes(std::vector<Extreme>& list) {
  for (auto [width, height] : std::initializer_list<std::pair<int, int>>{{1, 1}, {1, 40}, {40, 1}, {2, 2}, {37, 23}, {7, 61}}) {
    list.push_back({fmt::format("size_{}x{}", width, height), "picture sizes",
                    "at rest as the capture sees it; moving within the colours, finite",
                    [width = width, height = height](Probe& probe) {
                      expectSharp(probe, barShot(0, width / 4, width / 4 * 3 + 1, width, height));
                      Shot shot = set(barShot(9, width / 4, width / 4 * 3 + 1, width, height), {{"limit", "10"}});
                      expectWithin(probe, shot, kBack, kBar);
                    }});
  }
  list.push_back({"size_1xN_shortens_and_says", "picture sizes",
                  "the limit is a share of the width: on a picture of width 1 it is met by all that moves, and said",
                  [](Probe& probe) {
                    Shot shot = set(shotOf("oracles/quad_2d", 1, 40, {{"left", 0}, {"right", 1}, {"top", 12}, {"bottom", 28}, {"d_x", 0}, {"d_y", 9}}), {{"limit", "0.1"}});
                    if (probe.filters()) probe.expect(warnedOf(probe.picture(shot), "farther than the limit"), "not said");
                    expectNearerToTruth(probe, set(shot, {{"limit", "10"}}));
                  }});
  for (const char* tile : {"1", "7", "1024"})
    list.push_back({fmt::format("tile_{}", tile), "tiles", "every blur is nearer to truth than none, whatever the tile",
                    [tile](Probe& probe) {
                      Shot shot = set(barShot(12, 17, 31), {{"limit", "0.5"}, {"tile", tile}});
                      expectWithin(probe, shot, kBack, kBar);
                      expectNearerToTruth(probe, shot);
                    }});
  list.push_back({"tile_1_limit_10", "tiles", "a reach of thousands of tiles ends at the picture",
                  [](Probe& probe) {
                    Shot shot = set(barShot(12, 17, 31, 24, 8), {{"limit", "10"}, {"tile", "1"}});
                    expectWithin(probe, shot, kBack, kBar);
                    expectNearerToTruth(probe, shot);
                  }});
  list.push_back({"limit_0", "tiles", "nothing blurs, all that moves is counted",
                  [](Probe& probe) {
                    if (!probe.filters()) return;
                    Shot shot = set(barShot(12), {{"limit", "0"}});
                    expectSharp(probe, shot);
                    probe.expect(warnedOf(probe.picture(shot), "farther than the limit"), "not said");
                  }});
  list.push_back({"opposite_motions_in_one_tile", "tiles", "every blur is nearer to truth than none",
                  [](Probe& probe) {
                    Shot shot = shotOf("oracles/bar", 48, 8, {{"left", 16}, {"right", 32}, {"d_f", 10}, {"foreground", kBar}, {"background", kBack}});
                    shot.moves = {"background=-6,0,0"};
                    shot = set(shot, {{"limit", "1"}, {"tile", "64"}});
                    expectNearerToTruth(probe, shot);
                  }});
}

// ---- exposure and samples

void addExposures(std::vector<Extreme>& list) {
  for (const char* anchor : {"close", "centre", "open"}) {
    list.push_back({fmt::format("exposure_0_{}", anchor), "exposure", "an instant is the capture, bit for bit",
                    [anchor](Probe& probe) {
                      Shot shot = anchored(set(shotOf("stability/extreme", 48, 32), {{"limit", "10"}}), anchor);
                      shot.exposure = 0;
                      expectSharp(probe, shot);
                    }});
    list.push_back({fmt::format("exposure_3_{}", anchor), "exposure", "longer than a frame: the displacement is that of the window, and truth the exact coverage",
                    [anchor](Probe& probe) {
                      Shot shot = anchored(set(barShot(4, 16, 32), {{"limit", "10"}, {"tile", "8"}}), anchor);
                      shot.exposure = 3;  // of 0.5 for which 4 px are meant: 24 px
                      double from = anchor == std::string("close") ? -1 : anchor == std::string("centre") ? -0.5 : 0;
                      expectTruth(probe, shot, [&](int x, int) {
                        return kBack + (kBar - kBack) * coverage(16, 32, 24, from, from + 1, x + 0.5);
                      }, kBarBound);
                      expectWithin(probe, shot, kBack, kBar);
                      expectVelocity(probe, shot, [](double x, double) { return x >= 16 && x < 32 ? dvec2(24, 0) : dvec2(0); }, 1e-3);
                      expectNearerToTruth(probe, shot);
                    }});
  }
  list.push_back({"exposure_1", "exposure", "a whole frame: every blur is nearer to truth than none",
                  [](Probe& probe) {
                    Shot shot = set(barShot(6), {{"limit", "10"}, {"tile", "8"}});
                    shot.exposure = 1;
                    expectNearerToTruth(probe, shot);
                  }});
  list.push_back({"exposure_3_extrapolated", "exposure", "the path of one frame stretched over three is said",
                  [](Probe& probe) {
                    Shot shot = set(barShot(4), {{"limit", "10"}, {"displacement", "extrapolated"}});
                    shot.exposure = 3;
                    bool said = warnedOf(probe.picture(shot), "stretched over an exposure of more than one");
                    probe.expect(said == probe.filters(), said ? "said of a picture that is not" : "not said");
                  }});
  for (const char* samples : {"1", "2", "3", "15"})
    list.push_back({fmt::format("samples_{}", samples), "samples", "few and odd numbers of samples: at rest exact, else within the colours",
                    [samples](Probe& probe) {
                      expectSharp(probe, set(barShot(0), {{"samples", samples}}));
                      for (const char* anchor : {"close", "centre", "open"})
                        expectWithin(probe, anchored(set(barShot(11), {{"samples", samples}, {"limit", "10"}}), anchor), kBack, kBar);
                    }});
  list.push_back({"samples_1_truth", "samples", "one midpoint sample is the capture of the bar half way back",
                  [](Probe& probe) {
                    if (!probe.isTruth()) return;
                    const Image& one = colorIn(probe.picture(set(barShot(8), {{"samples", "1"}})));
                    probe.expect(countDifferent(one, colorIn(probe.sharp(barShot(0, 12, 28))), 0) == 0, "it is not");
                  }});
}

// ---- scales and places

Shot room(const std::vector<Setting>& settings = {}) {
  return set(shotOf("stability/extreme", 48, 32, settings), {{"limit", "10"}, {"tile", "8"}, {"samples", "16"}});
}

void addPlaces(std::vector<Extreme>& list) {
  // D9: powers of two change no bit; of other scales silhouettes flip by rounding, 0.1 % of the pixels.
  for (double scale : {1. / 1048576, 1048576.})
    list.push_back({scale < 1 ? "scale_2_to_minus_20" : "scale_2_to_20", "scale", "powers of two change no bit",
                    [scale](Probe& probe) { expectSame(probe, room(), room({{"scale", scale}}), 0, 0); }});
  for (auto [name, scale] : std::initializer_list<std::pair<const char*, double>>{
           {"1e_6", 1e-6}, {"1e_3", 1e-3}, {"0_37", 0.37}, {"1e3", 1e3}, {"1e6", 1e6}})
    list.push_back({fmt::format("scale_{}", name), "scale", "the same picture: 0.1 % of the pixels may differ by more than 1e-5",
                    [scale = scale](Probe& probe) { expectSame(probe, room(), room({{"scale", scale}}), 1e-5, 1e-3 + 1 / 1536.); }});

  const dvec2 still(0);
  for (auto [name, offset] : std::initializer_list<std::pair<const char*, double>>{{"1e5", 1e5}, {"1e6", 1e6}, {"1e7", 1e7}}) {
    for (int nesting : {0, 1, 2, 3}) {
      const char* how[] = {"", "_in_a_node", "_there_and_back", "_in_its_vertices"};
      bool main = nesting == 0 || offset == 1e7;
      if (!main) continue;
      list.push_back({fmt::format("offset_{}{}", name, how[nesting]), "world offset",
                      "a static scene stands still within 1e-3 px; a moving one looks as at the origin",
                      [offset = offset, nesting, still](Probe& probe) {
                        Setting there{"offset", offset}, nested{"nesting", double(nesting)};
                        expectVelocity(probe, room({there, nested, {"speed", 0}}), [&](double, double) { return still; }, 1e-3);
                        expectSame(probe, room(), room({there, nested}), 1e-4, 2e-3);
                        Setting pan{"camera_speed", 6.0625}, turn{"turn", 3};
                        expectSame(probe, room({pan, turn}), room({there, nested, pan, turn}), 1e-4, 2e-3);
                      }});
    }
  }
  for (auto [name, frame] : std::initializer_list<std::pair<const char*, int>>{{"1e6", 1000000}, {"2_to_31", 2147483647}})
    list.push_back({fmt::format("frame_{}", name), "far times", "the same motion at any time of day",
                    [frame = frame](Probe& probe) {
                      Shot late = room({{"rest_s", frame / 24.}, {"camera_speed", 6.0625}});
                      late.frame = frame;
                      expectSame(probe, room({{"camera_speed", 6.0625}}), late, 1e-4, 2e-3);
                    }});
}

// ---- cameras

constexpr int kWide = 48, kHigh = 32;
constexpr double kFocal = 32, kNear = 0.1;

Shot planes(int kind, const std::vector<Setting>& settings = {}) {
  std::vector<Setting> all = {{"kind", double(kind)}};
  all.insert(all.end(), settings.begin(), settings.end());
  return set(shotOf("stability/planes", kWide, kHigh, all), {{"limit", "10"}, {"tile", "8"}});
}

dvec2 pixelOf(const dvec3& p) { return dvec2(kFocal * p.x / p.z, kFocal * p.y / p.z); }

// Screen path from `from` to `to` (x right, y down, z ahead; metres), in double precision: where it ends behind the plane
// at `near`, the part up to there, extrapolated to the whole length.
dvec2 pathOf(const dvec3& from, dvec3 to, double near) {
  if (to.z >= near) return pixelOf(to) - pixelOf(from);
  double s = (from.z - near) / (from.z - to.z);
  return (pixelOf(glm::mix(from, to, s)) - pixelOf(from)) / s;
}

const dvec2 kUnknown(NAN);

// A point of the floor `below` the camera, or nothing above the horizon.
bool floorAt(double x, double y, double below, dvec3& point) {
  double z = below * kFocal / (y - kHigh / 2.);
  point = dvec3((x - kWide / 2.) * z / kFocal, below, z);
  return y > kHigh / 2. && z > kNear;
}

// Displacement of what moves by `step` (x right, y down, z ahead, metres over the exposure) before the camera.
dvec2 displacementOf(const dvec3& point, const dvec3& step, const std::string& anchor) {
  dvec3 open = anchor == "open" ? point : point - step * (anchor == "centre" ? 0.5 : 1.0);
  dvec3 close = anchor == "close" ? point : point + step * (anchor == "centre" ? 0.5 : 1.0);
  double near = kNear * 1.001;
  return pathOf(point, close, near) - pathOf(point, open, near);
}

// Direction of a pixel after the camera turned to its left by `angle` radians.
dvec3 turnedSky(double x, double y, double angle) {
  dvec3 d((x - kWide / 2.) / kFocal, (y - kHigh / 2.) / kFocal, 1);
  return dvec3(d.x * std::cos(angle) + std::sin(angle), d.y, std::cos(angle) - d.x * std::sin(angle));
}

// Single precision of the path's ends: a few units in the last place of depths near the near plane.
constexpr double kPathShare = 1e-4, kPathPx = 2e-3;

void addCameras(std::vector<Extreme>& list) {
  for (const char* anchor : {"close", "centre", "open"}) {
    for (auto [name, ahead] : std::initializer_list<std::pair<const char*, double>>{{"forward", -20}, {"back", 20}, {"by_a_hair", -1e-4}})
      list.push_back({fmt::format("camera_{}_over_a_floor_{}", name, anchor), "near plane",
                      "displacements are those of 11.3 in double precision, whatever passes behind the camera",
                      [ahead = ahead, anchor](Probe& probe) {
                        Shot shot = anchored(planes(1, {{"camera_z", ahead}, {"depth", 1.5}, {"extent", 400}}), anchor);
                        expectPath(probe, shot, [&](double x, double y) {
                          dvec3 point;
                          return floorAt(x, y, 1.5, point) && point.z < 190 ? displacementOf(point, {0, 0, ahead}, anchor) : kUnknown;
                        }, kPathShare, kPathPx);
                        expectWithin(probe, shot, 0.25, 1);
                      }});
    for (auto [name, away] : std::initializer_list<std::pair<const char*, double>>{
             {"from_behind", 12}, {"to_behind", -12}, {"to_the_camera", -4}, {"to_the_near_plane", -3.9}})
      list.push_back({fmt::format("card_{}_{}", name, anchor), "near plane",
                      "displacements are those of 11.3 in double precision, and what was extrapolated is said",
                      [away = away, anchor](Probe& probe) {
                        Shot shot = anchored(planes(2, {{"velocity_z", -away}, {"velocity_x", 0.5}}), anchor);
                        auto on_card = [](double x, double y) {
                          return std::abs(x - kWide / 2.) < 15 && std::abs(y - kHigh / 2.) < 15;
                        };
                        expectPath(probe, shot, [&](double x, double y) {
                          dvec3 point((x - kWide / 2.) / kFocal * 4, (y - kHigh / 2.) / kFocal * 4, 4);
                          return on_card(x, y) ? displacementOf(point, {0.5, 0, away}, anchor) : dvec2(NAN);
                        }, kPathShare, kPathPx);
                        double share = anchor == std::string("centre") ? 0.5 : 1;
                        bool back = anchor != std::string("open"), ahead = anchor != std::string("close");
                        bool crosses = (back && 4 - away * share < 1.001 * kNear) || (ahead && 4 + away * share < 1.001 * kNear);
                        bool said = warnedOf(probe.picture(shot), "behind the near plane");
                        probe.expect(said == crosses, said ? "said of what does not cross it" : "not said");
                        expectWithin(probe, shot, 0.2, 1);
                      }});
  }
  for (double turn : {10., 45., 85., 100., 170., -170.})
    list.push_back({fmt::format("turn_{}{:g}", turn < 0 ? "minus_" : "", std::abs(turn)), "all sky",
                    "the sky moves as directions do, and keeps its colour",
                    [turn](Probe& probe) {
                      double angle = turn * 3.14159265358979323846 / 180;
                      for (double near : {kNear, 5.0}) {  // which the sky has nothing to do with
                        Shot shot = planes(0, {{"turn", turn}, {"near", near}});
                        expectPath(probe, shot, [&](double x, double y) {
                          dvec3 now = turnedSky(x, y, 0), before = turnedSky(x, y, -angle);
                          return -pathOf(now, before, 1. / 64);
                        }, kPathShare, kPathPx);
                        expectSame(probe, shot, planes(0), 1e-6, 0);
                      }
                    }});
  list.push_back({"only_sky_at_rest", "all sky", "as the capture sees it", [](Probe& probe) { expectSharp(probe, planes(0)); }});
  for (auto [name, near] : std::initializer_list<std::pair<const char*, double>>{{"", 0.1}, {"_that_the_near_plane_cuts", 3.2}, {"_all_before_the_near_plane", 5}})
    list.push_back({fmt::format("inside_a_ball{}", name), "camera inside", "raster and rays see the same; one colour stays one",
                    [near = near](Probe& probe) {
                      expectSharp(probe, planes(4, {{"near", near}}));
                      Shot shot = planes(4, {{"near", near}, {"velocity_x", 1}});
                      if (near == 3.2) return expectWithin(probe, shot, 0.2, 0.9);
                      double value = near < 1 ? 0.9 : 0.2;
                      expectWithin(probe, shot, value, value);
                    }});
  list.push_back({"orthographic_far_away", "near plane", "a parallel camera sees as far as there is something",
                  [](Probe& probe) {
                    Shot shot = planes(2, {{"orthographic", 1}, {"focal", 32000}, {"aside", 10}});
                    expectSharp(probe, shot);
                    expectWithin(probe, shot, 0.2, 0.2);
                  }});
}

// ---- what is large, and what is fast

void addExtents(std::vector<Extreme>& list) {
  for (auto [name, extent] : std::initializer_list<std::pair<const char*, double>>{{"2e4", 2e4}, {"2e7", 2e7}})
    list.push_back({fmt::format("floor_{}_m_wide", name), "scale",
                    "what is near on a large triangle moves as precisely as on a small one",
                    [extent = extent](Probe& probe) {
                      Shot shot = planes(1, {{"camera_x", 0.5}, {"camera_z", -1}, {"depth", 1.5}, {"extent", extent}});
                      expectPath(probe, shot, [&](double x, double y) {
                        dvec3 point;
                        return floorAt(x, y, 1.5, point) ? displacementOf(point, {-0.5, 0, -1}, "close") : kUnknown;
                      }, 1e-3, 1e-2);
                    }});
  for (auto [name, turns] : std::initializer_list<std::pair<const char*, double>>{{"32_turns", 32}, {"1000_turns", 1000}})
    list.push_back({fmt::format("spin_of_{}", name), "displacement",
                    "what turns many times within the exposure is seen wherever it comes: rays as raster",
                    [turns = turns](Probe& probe) {
                      if (!probe.isTruth()) return;
                      Shot shot = set(planes(2, {}), {{"samples", "23"}, {"mark_regions", "false"}});
                      shot.spins = {fmt::format("card=0,0,1,{}", 2 * 360 * turns)};
                      expectSame(probe, shot, set(shot, {{"mode", "raster"}}), 1e-5, 4e-3);
                    }});
}

// ---- surfaces

void addSurfaces(std::vector<Extreme>& list) {
  for (auto [name, depth] : std::initializer_list<std::pair<const char*, double>>{{"1_mm", 1e-3}, {"1_um", 1e-6}, {"0", 1e-12}})
    list.push_back({fmt::format("floor_{}_below", name), "grazing", "raster and rays see the same at rest; within the colours",
                    [depth = depth](Probe& probe) {
                      expectSharp(probe, planes(1, {{"depth", depth}}));
                      expectWithin(probe, planes(1, {{"depth", depth}, {"camera_x", 0.5}}), 0.25, 1);
                    }});
  for (double order : {1., -1.}) {
    std::string suffix = order > 0 ? "" : "_other_way_round";
    list.push_back({"coplanar_cards" + suffix, "equal depths", "of equal depths the first instance is seen, by raster and rays",
                    [order](Probe& probe) {
                      expectSharp(probe, planes(3, {{"order", order}}));
                      expectWithin(probe, planes(3, {{"order", order}, {"velocity_x", 1}}), 0.2, 0.9);
                      double first = order > 0 ? 0.9 : 0.5;  // at (2, 0), where both are
                      double seen = colorIn(probe.sharp(planes(3, {{"order", order}}))).at(32, 16, 0);
                      probe.expect(std::abs(seen - first) < 1e-6, fmt::format("{} is seen, not {}", seen, first));
                    }});
    list.push_back({"coplanar_cards_that_lean" + suffix, "equal depths", "depths that differ by rounding: one of the two is seen",
                    [order](Probe& probe) {
                      Shot still = planes(3, {{"order", order}, {"lean", 50}});
                      if (!probe.isTruth()) expectSharp(probe, still);
                      expectWithin(probe, still, 0.2, 0.9);
                      expectWithin(probe, planes(3, {{"order", order}, {"lean", 50}, {"velocity_x", 1}}), 0.2, 0.9);
                    }});
  }
  list.push_back({"cards_a_hair_apart", "equal depths", "1e-5 of the depth apart: raster and rays see the nearer one",
                  [](Probe& probe) {
                    expectSharp(probe, planes(3, {{"gap", 4e-5}, {"lean", 50}}));
                    expectWithin(probe, planes(3, {{"gap", 4e-5}, {"lean", 50}, {"velocity_x", 1}}), 0.2, 0.9);
                  }});
  list.push_back({"one_triangle_over_the_picture", "triangles", "and behind the camera: as the capture sees it; one colour",
                  [](Probe& probe) {
                    expectSharp(probe, planes(5));
                    expectSame(probe, planes(5, {{"velocity_x", 3}}), planes(5), 1e-6, 0.25);
                  }});
  list.push_back({"triangles_of_no_area", "triangles", "and nodes of no triangles: as if they were not there",
                  [](Probe& probe) {
                    Setting x{"velocity_x", 0.7031}, y{"velocity_y", 0.2969};
                    expectSame(probe, planes(6, {x, y}), planes(2, {x, y}), 1e-6, 0);
                  }});
  list.push_back({"thousands_of_instances", "triangles", "raster and rays see the same; within the colours",
                  [](Probe& probe) {
                    Shot shot = planes(8, {{"velocity_x", 0.7}, {"velocity_y", 0.3}});
                    expectWithin(probe, shot, 0.2, 0.7);
                    shot.exposure = 0;
                    expectSharpBut(probe, shot, 8);
                  }});
  list.push_back({"a_million_triangles", "triangles", "smaller than pixels: raster and rays see the same; within the colours",
                  [](Probe& probe) {
                    Shot shot = planes(9, {{"velocity_x", 0.7}, {"velocity_y", 0.3}});
                    expectWithin(probe, shot, 0.2, 0.9);
                    shot.exposure = 0;
                    expectSharpBut(probe, shot, 2);
                  }});
  for (double value : {0., 0.9})
    list.push_back({value > 0 ? "equal_luminance" : "black", "equal colours", "motion that cannot be seen is not seen",
                    [value](Probe& probe) {
                      Shot shot = planes(7, {{"value", value}, {"velocity_x", 0.7}});
                      // Luminance cannot tell one surface from the other, and says so.
                      if (!warnedOf(probe.picture(shot), "as bright as the foreground")) expectWithin(probe, shot, value, value);
                    }});
  list.push_back({"light_of_1e29", "equal colours", "radiance near the end of single precision stays finite",
                  [](Probe& probe) { probe.picture(room({{"brightness", 3e26}})); }});
}

}  // namespace

const std::vector<Extreme>& extremes() {
  static const std::vector<Extreme> list = [] {
    std::vector<Extreme> all;
    addDisplacements(all);
    addSizes(all);
    addExposures(all);
    addPlaces(all);
    addCameras(all);
    addExtents(all);
    addSurfaces(all);
    return all;
  }();
  return list;
}

}  // namespace strobe::stability
