// SPDX-License-Identifier: MIT
// Each parameter of the pipeline ue5 alone, by pictures in closed form and by counted pixels. The other three are off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/gather_1d.h"
#include "oracle/render.h"
#include "oracle/row_case.h"

namespace strobe::oracle {
namespace render_ue5_test {

constexpr int kWidth = 256, kRows = 24, kTile = 16;
const std::vector<std::string> kCounted = {"copied", "cheap", "full"};

Numbers motions(double d_front, double d_back) { return {{"d_f", d_front}, {"d_b", d_back}}; }

class RenderUe5 : public RenderTest {
 protected:
  // The shot with one parameter on ("NAME=VALUE", may be empty).
  static lab::Shot only(const lab::Shot& shot, const std::string& parameter, std::vector<std::string> settings = {},
                        const std::string& anchor = "centre") {
    settings.insert(settings.begin(), {"half_resolution=false", "cheap=false", "nearest_depth=false"});
    if (!parameter.empty()) settings.push_back(parameter);
    return with(shot, "ue5", settings, anchor);
  }

  static uint64_t gathered(const lab::Picture& picture) {
    uint64_t sum = 0;
    for (const std::string& path : kCounted) sum += counterOf(picture, "gather." + path);
    return sum;
  }
};

// --- Half resolution

bool onGrid(int x, int y) { return x % 2 == 0 && y % 2 == 0; }

// Linear interpolation of the pixels with even coordinates, constant beyond the last even pixel.
double between(const image::Image& color, int x, int y) {
  const int left = x - x % 2, top = y - y % 2;
  const int right = left + 2 * (x % 2) < color.width ? left + 2 * (x % 2) : left;
  const int bottom = top + 2 * (y % 2) < color.height ? top + 2 * (y % 2) : top;
  return (double(color.at(left, top, 0)) + color.at(right, top, 0) + color.at(left, bottom, 0) +
          color.at(right, bottom, 0)) /
         4;
}

// If everything moves far, a quarter of the pixels is gathered. These pixels have the colours of full resolution.
TEST_F(RenderUe5, HalfResolutionGathersAQuarter) {
  for (int width : {kWidth, 251})
    for (const Anchor& anchor : anchors()) {
      lab::Shot shot = shotOf("textured_bar", width, 23, motions(31, -17));
      const lab::Picture all = render(only(shot, "", {"jitter=ign"}, anchor.name));
      const lab::Picture half = render(only(shot, "half_resolution=true", {"jitter=ign"}, anchor.name));
      EXPECT_EQ(gathered(all), uint64_t(width * 23));
      EXPECT_EQ(gathered(half), uint64_t((width + 1) / 2 * 12)) << anchor.name;
      double worst = 0;
      for (int y = 0; y < 23; ++y)
        for (int x = 0; x < width; ++x) {
          if (onGrid(x, y)) EXPECT_EQ(colorOf(half).at(x, y, 0), colorOf(all).at(x, y, 0)) << x << ' ' << y;
          else worst = std::max(worst, std::abs(colorOf(half).at(x, y, 0) - between(colorOf(all), x, y)));
        }
      EXPECT_LT(worst, 1e-6) << anchor.name;
    }
}

// Tiles have 16 px: the tiles of the columns [96, 160) show only the bar [90, 170). Motion below 16 px makes no tile
// heavy.
TEST_F(RenderUe5, HalfResolutionLeavesTilesWithASlowPixel) {
  for (double moved : {16., 15.9}) {
    lab::Shot shot = shotOf("bar", kWidth, 32, {{"left", 90}, {"right", 170}, {"d_f", moved}});
    const int heavy = moved < 16 ? 0 : 64 * 32;
    const lab::Picture all = render(only(shot, "")), half = render(only(shot, "half_resolution=true"));
    EXPECT_EQ(gathered(half), uint64_t(kWidth * 32 - heavy * 3 / 4));
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (!heavy || x < 96 || x >= 160)
          ASSERT_EQ(colorOf(half).at(x, y, 0), colorOf(all).at(x, y, 0)) << x << ' ' << y;
  }
}

// --- Directions

// If all motion has one direction, the second direction equals the first one.
TEST_F(RenderUe5, TwoDirectionsOfOneMotionAreOne) {
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = shotOf("bar", kWidth, kRows);
    EXPECT_TRUE(identical(colorOf(render(only(shot, "directions=two", {}, anchor.name))),
                          colorOf(render(only(shot, "", {}, anchor.name)))));
  }
}

// A rectangle moves down, in a tile where another rectangle moves to the right by more. One direction leaves the lower
// edge sharp. The second of two directions blurs it, with half of the weight.
TEST_F(RenderUe5, TheSecondDirectionBlursHalf) {
  constexpr double kDown = 20, kBack = .2, kFront = .6;
  lab::Shot shot = shotOf("crossing", 96, 96,
                          {{"a_left", 4},
                           {"a_top", 4},
                           {"a_width", 8},
                           {"a_height", 8},
                           {"a_x", 24},
                           {"b_left", 24},
                           {"b_top", 20},
                           {"b_width", 60},
                           {"b_height", 40},
                           {"b_y", kDown}});
  const std::vector<std::string> settings = {"tile=96", "samples=64"};
  for (const Anchor& anchor : anchors()) {
    const image::Image one = colorOf(render(only(shot, "", settings, anchor.name)));
    const image::Image two = colorOf(render(only(shot, "directions=two", settings, anchor.name)));
    for (int y = 30; y < 92; ++y) {
      const double sharp = y < 60 ? kFront : kBack;
      const double covered = barAtCentre(20, 60, kDown, anchor.window, y);
      EXPECT_NEAR(one.at(54, y, 0), sharp, 1e-6) << anchor.name << ' ' << y;
      // The edge is rounded to a tap, 1/64 of the exposure, and to a pixel, 1/20.
      EXPECT_NEAR(two.at(54, y, 0), .5 * sharp + .5 * (kBack + covered * (kFront - kBack)),
                  .5 * (kFront - kBack) * (1. / 64 + 1 / kDown) + 1e-4)
          << anchor.name << ' ' << y;
    }
  }
}

// --- Shortest and longest displacement of tiles

// Everything moves by 19 to 20 px, so taps have equal weights at any depth.
TEST_F(RenderUe5, CheapTapsHaveEqualWeight) {
  const Row row = rasterise({{96, 160, 20, {.9, .6, 8, 96}}, {-kInfinity, kInfinity, 19, {.4, .1, 8, 0}}}, kWidth);
  lab::Shot shot = only(shotOf("textured_bar", kWidth, kRows, motions(20, 19)), "cheap=true", {"jitter=ign"});
  const lab::Picture picture = render(shot);
  EXPECT_EQ(counterOf(picture, "gather.cheap"), uint64_t(kWidth * kRows));
  auto mean = [&](int x, double jitter) {
    double sum = 0;
    for (int i = 0; i < 8; ++i)
      for (int side : {1, -1}) sum += row[tapAt(x, side * 20 * (i + .5 + jitter) / 16)].colour / 16;
    return sum;
  };
  expectPerPixel({"cheap", shot, mean, 112, 144}, colorOf(picture));
}

// Every tile on the bar's path has static pixels: no tap is cheap, and the parameter does not change the picture.
TEST_F(RenderUe5, NoTapIsCheapBesideASlowSurface) {
  lab::Shot shot = shotOf("bar", kWidth, kRows, {{"left", 120}, {"right", 136}, {"d_f", 40}});
  const lab::Picture cheap = render(only(shot, "cheap=true"));
  EXPECT_GT(counterOf(cheap, "gather.full"), 0u);
  EXPECT_EQ(counterOf(cheap, "gather.cheap"), 0u);
  EXPECT_TRUE(identical(colorOf(cheap), colorOf(render(only(shot, "")))));
}

// --- Nearest depth

// The rectangle `a` is in front of `b`, and both are in front of a static background. Each grows by a pixel on all
// eight sides over the surface behind it.
TEST_F(RenderUe5, NearerSurfacesGrowByAPixel) {
  lab::Shot shot = shotOf("crossing", 96, 96, {{"a_left", 40}, {"a_top", 20}, {"a_x", -7}, {"b_top", 32}, {"b_y", 10}});
  shot = only(shot, "nearest_depth=true");
  shot.taps = {"nearest_velocity.nearest"};
  const lab::Picture picture = render(shot);
  const image::Image& nearest = picture.frame.taps.at("nearest_velocity.nearest").floats;
  auto within = [](int x, int y, int left, int top) {
    return x >= left - 1 && x <= left + 32 && y >= top - 1 && y <= top + 32;
  };
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const bool in_a = within(x, y, 40, 20), in_b = !in_a && within(x, y, 32, 32);
      ASSERT_NEAR(nearest.at(x, y, 0), in_a ? -7 : 0, 1e-4) << x << ' ' << y;
      ASSERT_NEAR(nearest.at(x, y, 1), in_b ? 10 : 0, 1e-4) << x << ' ' << y;
    }
}

// The filter along a row, with the bar's displacement in the two pixels beside the bar at their own depth and colour.
TEST_F(RenderUe5, PixelsBesideTheBarMoveWithIt) {
  for (const Anchor& anchor : anchors()) {
    Row row = rasterise({{96, 160, 20, {.9, .6, 8, 96}}, {-kInfinity, kInfinity, 0, {.4, .1, 8, 0}}}, kWidth);
    row[95].d = row[160].d = 20;
    auto shot = [&](const std::string& parameter) {
      return only(shotOf("textured_bar", kWidth, kRows, motions(20, 0)), parameter, {"jitter=ign", "mirror=false"},
                  anchor.name);
    };
    const image::Image color = colorOf(render(shot("nearest_depth=true")));
    EXPECT_FALSE(identical(color, colorOf(render(shot("")))));
    auto paired = [&](int x, double jitter) {
      return pairedAt(row, 20, x, {.samples = 16, .jitter = jitter, .mirror = false, .window = anchor.window});
    };
    expectPerPixel({"nearest " + anchor.name, shot("nearest_depth=true"), paired, 94, 162}, color);
  }
}

}  // namespace render_ue5_test
}  // namespace strobe::oracle
