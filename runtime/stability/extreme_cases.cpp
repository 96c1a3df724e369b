// SPDX-License-Identifier: MIT
// Cases of displacements, picture sizes, tiles, exposures, samples, scales, places and times.
#include <cmath>

#include "image/regions.h"
#include "stability/extreme_checks.h"

namespace strobe::stability::extreme {

using lab::Shot;

// ---- a bar over a background at rest

constexpr int kBarWidth = 48, kBarHeight = 4;
constexpr double kBar = 1, kBack = 0.2;

static Shot barShot(double displacement, double left = 16, double right = 32, int width = kBarWidth,
                    int height = kBarHeight) {
  return shotOf("oracles/bar", width, height,
                {{"left", left}, {"right", right}, {"d_f", displacement}, {"foreground", kBar}, {"background", kBack}});
}

// Share of the window [from, to] (exposures from the capture) for which a bar [left, right) that moves by `d` px covers
// x.
static double coverage(double left, double right, double d, double from, double to, double x) {
  if (d == 0) return x >= left && x < right;
  double a = (x - left) / d, b = (x - right) / d;  // it is at x between these times
  return std::max(0.0, std::min(to, std::max(a, b)) - std::max(from, std::min(a, b))) / (to - from);
}

// Two silhouettes of a jump of 0.8, each half a time sample off at most (D8).
constexpr double kBarBound = 2 * (kBar - kBack) / (2 * kTruthTimes) + 1e-4;

static void checkBar(Probe& probe, double displacement, double left = 16, double right = 32) {
  Shot shot = set(barShot(displacement, left, right), {{"limit", "10"}, {"tile", "8"}});
  expectTruth(
      probe, shot,
      [&](int x, int) { return kBack + (kBar - kBack) * coverage(left, right, displacement, -1, 0, x + 0.5); },
      kBarBound);
  expectWithin(probe, shot, kBack, kBar);
}

void addDisplacements(std::vector<Extreme>& list) {
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"zero", 0}, {"1e_8", 1e-8}, {"0_49", 0.49}, {"half", 0.5}, {"minus_half", -0.5}})
    list.push_back({fmt::format("displacement_{}_px", name), "displacement",
                    "half a pixel reaches no other centre: copied, bit for bit", [d = d](Probe& probe) {
                      expectSharp(probe, set(barShot(d), {{"limit", "10"}}));
                    }});
  for (const char* anchor : {"close", "centre", "open"})
    list.push_back({fmt::format("displacement_0_51_px_{}", anchor), "displacement",
                    "colours stay between those of bar and background", [anchor](Probe& probe) {
                      expectWithin(probe, anchored(set(barShot(0.51), {{"limit", "10"}}), anchor), kBack, kBar);
                    }});
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"tile", 8}, {"minus_tile", -8}, {"two_tiles", 16}, {"picture", 48}})
    list.push_back({fmt::format("displacement_one_{}", name), "displacement",
                    "truth is the exact coverage; every blur is nearer to it than none", [d = d](Probe& probe) {
                      checkBar(probe, d);
                      expectNearerToTruth(probe, set(barShot(d), {{"limit", "10"}, {"tile", "8"}}));
                    }});
  for (auto [name, d] : std::initializer_list<std::pair<const char*, double>>{
           {"ten_pictures", 480}, {"1e7_px", 1e7}, {"minus_1e7_px", -1e7}})
    list.push_back({fmt::format("displacement_{}", name), "displacement",
                    "truth is the exact coverage; filters stay between the colours",
                    [d = d](Probe& probe) { checkBar(probe, d); }});
  for (auto [name, left, d] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"enters", -4, 24}, {"has_entered", 8, 24}, {"has_left", -24, -24}, {"passes_by", 60, 160}})
    list.push_back({fmt::format("object_{}", name), "displacement",
                    "truth knows what was outside of the picture; filters stay between the colours",
                    [left = left, d = d](Probe& probe) { checkBar(probe, d, left, left + 16); }});
  for (auto [name, left, right] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"one_pixel", 24, 25}, {"a_tenth_of_a_pixel", 24.45, 24.55}})
    list.push_back({fmt::format("bar_of_{}", name), "displacement", "thinner than its path: truth is w/d",
                    [left = left, right = right](Probe& probe) { checkBar(probe, 12, left, right); }});
  list.push_back(
      {"displacement_over_the_limit", "displacement", "what is shortened is counted; truth is not", [](Probe& probe) {
         Shot shot = set(barShot(40), {{"limit", "0.1"}, {"tile", "8"}});
         expectWithin(probe, shot, kBack, kBar);
         bool said = warnedOf(probe.picture(shot), "farther than the limit");
         probe.expect(said == probe.filters(), said ? "truth was shortened" : "not said");
         expectTruth(
             probe, shot, [](int x, int) { return kBack + (kBar - kBack) * coverage(16, 32, 40, -1, 0, x + 0.5); },
             kBarBound);
       }});
  for (auto [name, x, y] : std::initializer_list<std::tuple<const char*, double, double>>{
           {"diagonal", 8, 8}, {"diagonal_back", -8, 8}, {"steep", 3, -17}, {"far_diagonal", 34, 34}})
    list.push_back({fmt::format("displacement_{}", name), "displacement", "every blur is nearer to truth than none",
                    [x = x, y = y](Probe& probe) {
                      Shot shot =
                          shotOf("oracles/quad_2d", 48, 48,
                                 {{"left", 16}, {"right", 32}, {"top", 16}, {"bottom", 32}, {"d_x", x}, {"d_y", y}});
                      shot = set(shot, {{"limit", "2"}, {"tile", "8"}});
                      expectWithin(probe, shot, 0.1, 0.9);
                      expectNearerToTruth(probe, shot);
                    }});
}

// ---- sizes

void addSizes(std::vector<Extreme>& list) {
  for (auto [width, height] :
       std::initializer_list<std::pair<int, int>>{{1, 1}, {1, 40}, {40, 1}, {2, 2}, {37, 23}, {7, 61}}) {
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
                    Shot shot =
                        set(shotOf("oracles/quad_2d", 1, 40,
                                   {{"left", 0}, {"right", 1}, {"top", 12}, {"bottom", 28}, {"d_x", 0}, {"d_y", 9}}),
                            {{"limit", "0.1"}});
                    if (probe.filters())
                      probe.expect(warnedOf(probe.picture(shot), "farther than the limit"), "not said");
                    expectNearerToTruth(probe, set(shot, {{"limit", "10"}}));
                  }});
  for (const char* tile : {"1", "7", "1024"})
    list.push_back({fmt::format("tile_{}", tile), "tiles", "every blur is nearer to truth than none, whatever the tile",
                    [tile](Probe& probe) {
                      Shot shot = set(barShot(12, 17, 31), {{"limit", "0.5"}, {"tile", tile}});
                      expectWithin(probe, shot, kBack, kBar);
                      expectNearerToTruth(probe, shot);
                    }});
  list.push_back({"tile_1_limit_10", "tiles", "a reach of thousands of tiles ends at the picture", [](Probe& probe) {
                    Shot shot = set(barShot(12, 17, 31, 24, 8), {{"limit", "10"}, {"tile", "1"}});
                    expectWithin(probe, shot, kBack, kBar);
                    expectNearerToTruth(probe, shot);
                  }});
  list.push_back({"limit_0", "tiles", "nothing blurs, all that moves is counted", [](Probe& probe) {
                    if (!probe.filters()) return;
                    Shot shot = set(barShot(12), {{"limit", "0"}});
                    expectSharp(probe, shot);
                    probe.expect(warnedOf(probe.picture(shot), "farther than the limit"), "not said");
                  }});
  list.push_back({"opposite_motions_in_one_tile", "tiles", "every blur is nearer to truth than none", [](Probe& probe) {
                    Shot shot =
                        shotOf("oracles/bar", 48, 8,
                               {{"left", 16}, {"right", 32}, {"d_f", 10}, {"foreground", kBar}, {"background", kBack}});
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
    list.push_back(
        {fmt::format("exposure_3_{}", anchor), "exposure",
         "longer than a frame: the displacement is that of the window, and truth the exact coverage",
         [anchor](Probe& probe) {
           Shot shot = anchored(set(barShot(4, 16, 32), {{"limit", "10"}, {"tile", "8"}}), anchor);
           shot.exposure = 3;  // of 0.5 for which 4 px are meant: 24 px
           double from = anchor == std::string("close") ? -1 : anchor == std::string("centre") ? -0.5 : 0;
           expectTruth(
               probe, shot,
               [&](int x, int) { return kBack + (kBar - kBack) * coverage(16, 32, 24, from, from + 1, x + 0.5); },
               kBarBound);
           expectWithin(probe, shot, kBack, kBar);
           expectPath(
               probe, shot, [](double x, double) { return x >= 16 && x < 32 ? dvec2(24, 0) : dvec2(0); }, 0, 1e-3);
           expectNearerToTruth(probe, shot);
         }});
  }
  list.push_back({"exposure_1", "exposure", "a whole frame: every blur is nearer to truth than none", [](Probe& probe) {
                    Shot shot = set(barShot(6), {{"limit", "10"}, {"tile", "8"}});
                    shot.exposure = 1;
                    expectNearerToTruth(probe, shot);
                  }});
  list.push_back(
      {"exposure_3_extrapolated", "exposure", "the path of one frame stretched over three is said", [](Probe& probe) {
         Shot shot = set(barShot(4), {{"limit", "10"}, {"displacement", "extrapolated"}});
         shot.exposure = 3;
         bool said = warnedOf(probe.picture(shot), "stretched over an exposure of more than one");
         probe.expect(said == probe.filters(), said ? "said of a picture that is not" : "not said");
       }});
  for (const char* samples : {"1", "2", "3", "15"})
    list.push_back({fmt::format("samples_{}", samples), "samples",
                    "few and odd numbers of samples: at rest exact, else within the colours", [samples](Probe& probe) {
                      expectSharp(probe, set(barShot(0), {{"samples", samples}}));
                      for (const char* anchor : {"close", "centre", "open"})
                        expectWithin(probe, anchored(set(barShot(11), {{"samples", samples}, {"limit", "10"}}), anchor),
                                     kBack, kBar);
                    }});
  list.push_back(
      {"samples_1_truth", "samples", "one midpoint sample is the capture of the bar half way back", [](Probe& probe) {
         if (!probe.isTruth()) return;
         const image::Image& one = colorIn(probe.picture(set(barShot(8), {{"samples", "1"}})));
         probe.expect(image::countDifferent(one, colorIn(probe.sharp(barShot(0, 12, 28))), 0) == 0, "it is not");
       }});
}

// ---- scales and places

void addPlaces(std::vector<Extreme>& list) {
  // D9: powers of two change no bit; of other scales silhouettes flip by rounding, 0.1 % of the pixels.
  for (double scale : {1. / 1048576, 1048576.})
    list.push_back({scale < 1 ? "scale_2_to_minus_20" : "scale_2_to_20", "scale", "powers of two change no bit",
                    [scale](Probe& probe) {
                      expectSame(probe, room(), room({{"scale", scale}}), 0, 0);
                    }});
  for (auto [name, scale] : std::initializer_list<std::pair<const char*, double>>{
           {"1e_6", 1e-6}, {"1e_3", 1e-3}, {"0_37", 0.37}, {"1e3", 1e3}, {"1e6", 1e6}})
    list.push_back({fmt::format("scale_{}", name), "scale",
                    "the same picture: 0.1 % of the pixels may differ by more than 1e-5",
                    [scale = scale](Probe& probe) {
                      expectSame(probe, room(), room({{"scale", scale}}), 1e-5, 1e-3 + 1 / 1536.);
                    }});

  const dvec2 still(0);
  for (auto [name, offset] :
       std::initializer_list<std::pair<const char*, double>>{{"1e5", 1e5}, {"1e6", 1e6}, {"1e7", 1e7}}) {
    for (int nesting : {0, 1, 2, 3}) {
      const char* how[] = {"", "_in_a_node", "_there_and_back", "_in_its_vertices"};
      bool main = nesting == 0 || offset == 1e7;
      if (!main) continue;
      list.push_back({fmt::format("offset_{}{}", name, how[nesting]), "world offset",
                      "a static scene stands still within 1e-3 px; a moving one looks as at the origin",
                      [offset = offset, nesting, still](Probe& probe) {
                        Setting there{"offset", offset}, nested{"nesting", double(nesting)};
                        expectPath(
                            probe, room({there, nested, {"speed", 0}}), [&](double, double) { return still; }, 0, 1e-3);
                        expectSame(probe, room(), room({there, nested}), 1e-4, 2e-3);
                        Setting pan{"camera_speed", 6.0625}, turn{"turn", 3};
                        expectSame(probe, room({pan, turn}), room({there, nested, pan, turn}), 1e-4, 2e-3);
                      }});
    }
  }
  for (auto [name, frame] :
       std::initializer_list<std::pair<const char*, int>>{{"1e6", 1000000}, {"2_to_31", 2147483647}})
    list.push_back({fmt::format("frame_{}", name), "far times", "the same motion at any time of day",
                    [frame = frame](Probe& probe) {
                      Shot late = room({{"rest_s", frame / 24.}, {"camera_speed", 6.0625}});
                      late.frame = frame;
                      expectSame(probe, room({{"camera_speed", 6.0625}}), late, 1e-4, 2e-3);
                    }});
}

}  // namespace strobe::stability::extreme
