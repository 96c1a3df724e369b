// SPDX-License-Identifier: MIT
// Cases of cameras, large and fast things, and surfaces.
#include <cmath>

#include "math/constants.h"
#include "stability/extreme_checks.h"

namespace strobe::stability::extreme {

using lab::Shot;

// ---- cameras

constexpr int kWide = 48, kHigh = 32;
constexpr double kFocal = 32, kNear = 0.1;

static Shot planes(int kind, const std::vector<Setting>& settings = {}) {
  std::vector<Setting> all = {{"kind", double(kind)}};
  all.insert(all.end(), settings.begin(), settings.end());
  return set(shotOf("stability/planes", kWide, kHigh, all), {{"limit", "10"}, {"tile", "8"}});
}

static dvec2 pixelOf(const dvec3& p) { return dvec2(kFocal * p.x / p.z, kFocal * p.y / p.z); }

// Screen path from `from` to `to` (x right, y down, z ahead; metres), in double precision: where it ends behind the
// plane at `near`, the part up to there, extrapolated to the whole length.
static dvec2 pathOf(const dvec3& from, dvec3 to, double near) {
  if (to.z >= near) return pixelOf(to) - pixelOf(from);
  double s = (from.z - near) / (from.z - to.z);
  return (pixelOf(glm::mix(from, to, s)) - pixelOf(from)) / s;
}

static const dvec2 kUnknown(NAN);

// A point of the floor `below` the camera, or nothing above the horizon.
static bool floorAt(double x, double y, double below, dvec3& point) {
  double z = below * kFocal / (y - kHigh / 2.);
  point = dvec3((x - kWide / 2.) * z / kFocal, below, z);
  return y > kHigh / 2. && z > kNear;
}

// Displacement of what moves by `step` (x right, y down, z ahead, metres over the exposure) before the camera.
static dvec2 displacementOf(const dvec3& point, const dvec3& step, const std::string& anchor) {
  dvec3 open = anchor == "open" ? point : point - step * (anchor == "centre" ? 0.5 : 1.0);
  dvec3 close = anchor == "close" ? point : point + step * (anchor == "centre" ? 0.5 : 1.0);
  double near = kNear * 1.001;
  return pathOf(point, close, near) - pathOf(point, open, near);
}

// Direction of a pixel after the camera turned to its left by `angle` radians.
static dvec3 turnedSky(double x, double y, double angle) {
  dvec3 d((x - kWide / 2.) / kFocal, (y - kHigh / 2.) / kFocal, 1);
  return dvec3(d.x * std::cos(angle) + std::sin(angle), d.y, std::cos(angle) - d.x * std::sin(angle));
}

// Single precision of the path's ends: a few units in the last place of depths near the near plane.
constexpr double kPathShare = 1e-4, kPathPx = 2e-3;

void addCameras(std::vector<Extreme>& list) {
  for (const char* anchor : {"close", "centre", "open"}) {
    for (auto [name, ahead] :
         std::initializer_list<std::pair<const char*, double>>{{"forward", -20}, {"back", 20}, {"by_a_hair", -1e-4}})
      list.push_back({fmt::format("camera_{}_over_a_floor_{}", name, anchor), "near plane",
                      "displacements are those of 11.3 in double precision, whatever passes behind the camera",
                      [ahead = ahead, anchor](Probe& probe) {
                        Shot shot = anchored(planes(1, {{"camera_z", ahead}, {"depth", 1.5}, {"extent", 400}}), anchor);
                        expectPath(
                            probe, shot,
                            [&](double x, double y) {
                              dvec3 point;
                              return floorAt(x, y, 1.5, point) && point.z < 190
                                         ? displacementOf(point, {0, 0, ahead}, anchor)
                                         : kUnknown;
                            },
                            kPathShare, kPathPx);
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
                        expectPath(
                            probe, shot,
                            [&](double x, double y) {
                              dvec3 point((x - kWide / 2.) / kFocal * 4, (y - kHigh / 2.) / kFocal * 4, 4);
                              return on_card(x, y) ? displacementOf(point, {0.5, 0, away}, anchor) : dvec2(NAN);
                            },
                            kPathShare, kPathPx);
                        double share = anchor == std::string("centre") ? 0.5 : 1;
                        bool back = anchor != std::string("open"), ahead = anchor != std::string("close");
                        bool crosses =
                            (back && 4 - away * share < 1.001 * kNear) || (ahead && 4 + away * share < 1.001 * kNear);
                        bool said = warnedOf(probe.picture(shot), "behind the near plane");
                        probe.expect(said == crosses, said ? "said of what does not cross it" : "not said");
                        expectWithin(probe, shot, 0.2, 1);
                      }});
  }
  for (double turn : {10., 45., 85., 100., 170., -170.})
    list.push_back({fmt::format("turn_{}{:g}", turn < 0 ? "minus_" : "", std::abs(turn)), "all sky",
                    "the sky moves as directions do, and keeps its colour", [turn](Probe& probe) {
                      double angle = turn * kPi / 180;
                      for (double near : {kNear, 5.0}) {  // which the sky has nothing to do with
                        Shot shot = planes(0, {{"turn", turn}, {"near", near}});
                        expectPath(
                            probe, shot,
                            [&](double x, double y) {
                              dvec3 now = turnedSky(x, y, 0), before = turnedSky(x, y, -angle);
                              return -pathOf(now, before, 1. / 64);
                            },
                            kPathShare, kPathPx);
                        expectSame(probe, shot, planes(0), 1e-6, 0);
                      }
                    }});
  list.push_back(
      {"only_sky_at_rest", "all sky", "as the capture sees it", [](Probe& probe) { expectSharp(probe, planes(0)); }});
  for (auto [name, near] : std::initializer_list<std::pair<const char*, double>>{
           {"", 0.1}, {"_that_the_near_plane_cuts", 3.2}, {"_all_before_the_near_plane", 5}})
    list.push_back({fmt::format("inside_a_ball{}", name), "camera inside",
                    "raster and rays see the same; one colour stays one", [near = near](Probe& probe) {
                      expectSharp(probe, planes(4, {{"near", near}}));
                      Shot shot = planes(4, {{"near", near}, {"velocity_x", 1}});
                      if (near == 3.2) return expectWithin(probe, shot, 0.2, 0.9);
                      double value = near < 1 ? 0.9 : 0.2;
                      expectWithin(probe, shot, value, value);
                    }});
  list.push_back(
      {"orthographic_far_away", "near plane", "a parallel camera sees as far as there is something", [](Probe& probe) {
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
                      expectPath(
                          probe, shot,
                          [&](double x, double y) {
                            dvec3 point;
                            return floorAt(x, y, 1.5, point) ? displacementOf(point, {-0.5, 0, -1}, "close") : kUnknown;
                          },
                          1e-3, 1e-2);
                    }});
  for (auto [name, turns] :
       std::initializer_list<std::pair<const char*, double>>{{"32_turns", 32}, {"1000_turns", 1000}})
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
  for (auto [name, depth] :
       std::initializer_list<std::pair<const char*, double>>{{"1_mm", 1e-3}, {"1_um", 1e-6}, {"0", 1e-12}})
    list.push_back({fmt::format("floor_{}_below", name), "grazing",
                    "raster and rays see the same at rest; within the colours", [depth = depth](Probe& probe) {
                      expectSharp(probe, planes(1, {{"depth", depth}}));
                      expectWithin(probe, planes(1, {{"depth", depth}, {"camera_x", 0.5}}), 0.25, 1);
                    }});
  for (double order : {1., -1.}) {
    std::string suffix = order > 0 ? "" : "_other_way_round";
    list.push_back({"coplanar_cards" + suffix, "equal depths",
                    "of equal depths the first instance is seen, by raster and rays", [order](Probe& probe) {
                      expectSharp(probe, planes(3, {{"order", order}}));
                      expectWithin(probe, planes(3, {{"order", order}, {"velocity_x", 1}}), 0.2, 0.9);
                      double first = order > 0 ? 0.9 : 0.5;  // at (2, 0), where both are
                      double seen = colorIn(probe.sharp(planes(3, {{"order", order}}))).at(32, 16, 0);
                      probe.expect(std::abs(seen - first) < 1e-6, fmt::format("{} is seen, not {}", seen, first));
                    }});
    list.push_back({"coplanar_cards_that_lean" + suffix, "equal depths",
                    "depths that differ by rounding: one of the two is seen", [order](Probe& probe) {
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
  list.push_back({"one_triangle_over_the_picture", "triangles",
                  "and behind the camera: as the capture sees it; one colour", [](Probe& probe) {
                    expectSharp(probe, planes(5));
                    expectSame(probe, planes(5, {{"velocity_x", 3}}), planes(5), 1e-6, 0.25);
                  }});
  list.push_back(
      {"triangles_of_no_area", "triangles", "and nodes of no triangles: as if they were not there", [](Probe& probe) {
         Setting x{"velocity_x", 0.7031}, y{"velocity_y", 0.2969};
         expectSame(probe, planes(6, {x, y}), planes(2, {x, y}), 1e-6, 0);
       }});
  list.push_back(
      {"thousands_of_instances", "triangles", "raster and rays see the same; within the colours", [](Probe& probe) {
         Shot shot = planes(8, {{"velocity_x", 0.7}, {"velocity_y", 0.3}});
         expectWithin(probe, shot, 0.2, 0.7);
         shot.exposure = 0;
         expectSharpBut(probe, shot, 8);
       }});
  list.push_back({"a_million_triangles", "triangles",
                  "smaller than pixels: raster and rays see the same; within the colours", [](Probe& probe) {
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
                      if (!warnedOf(probe.picture(shot), "as bright as the foreground"))
                        expectWithin(probe, shot, value, value);
                    }});
  list.push_back(
      {"light_of_1e29", "equal colours", "radiance near the end of single precision stays finite", [](Probe& probe) {
         probe.picture(room({{"brightness", 3e26}}));
       }});
}

}  // namespace strobe::stability::extreme
