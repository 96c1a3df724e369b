// SPDX-License-Identifier: MIT
// The renderer's filters against the row filters in double precision, pixel by pixel with the pixel's own jitter, and
// their means over jitters against the numbers in docs/derivations.md. The jitter is interleaved gradient noise: down
// 160 rows of a column it is as even as 160 numbers can be.
#include <fmt/format.h>

#include <cmath>

#include "oracle/gather_1d.h"
#include "oracle/render.h"
#include "oracle/row_case.h"

namespace strobe::oracle {
namespace render_filters_test {

constexpr int kRows = 160;

double columnMean(const image::Image& color, int x) {
  double sum = 0;
  for (int y = 0; y < color.height; ++y) sum += color.at(x, y, 0) / color.height;
  return sum;
}

double meanOverJitters(const RowCase& filter, int x) {
  double sum = 0;
  for (double jitter : meanJitters()) sum += filter.expected(x, jitter) / 64;
  return sum;
}

class RenderFilters : public RenderTest {
 protected:
  // Compares each pixel with the row filter, then the means of columns with the mean over jitters.
  lab::Picture check(const RowCase& filter, double mean_tolerance) {
    lab::Picture picture = render(filter.shot);
    EXPECT_EQ(counterOf(picture, "tile_max.clamped"), 0u) << filter.what;
    expectPerPixel(filter, colorOf(picture));
    for (int x = filter.first; x < filter.last; ++x)
      EXPECT_NEAR(columnMean(colorOf(picture), x), meanOverJitters(filter, x), mean_tolerance)
          << filter.what << " " << x;
    return picture;
  }
};

const Strips kWhiteBar{{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}};

lab::Shot whiteBar(const std::string& pipeline, const std::string& anchor, std::vector<std::string> settings) {
  settings.insert(settings.end(), {"tile=20", "limit=0.1", "jitter=ign"});
  return with(shotOf("bar", 256, kRows), pipeline, settings, anchor);
}

TEST_F(RenderFilters, McGuireReproducesItsTable) {
  struct Line {
    int offset;
    double s15, s31;
  };
  const Line table[] = {{-10, 1, 1},       {-6, .9775, .9785}, {-4, .9459, .9494}, {-1, .8576, .8642},
                        {0, .6355, .6404}, {2, .5259, .5343},  {5, .2810, .3082},  {8, .0335, .0499}};
  Row row = rasterise(kWhiteBar, 256);
  for (int samples : {15, 31}) {
    RowCase filter{
        fmt::format("S = {}", samples), whiteBar("mcguire2012", "centre", {fmt::format("samples={}", samples)}),
        [&](int x, double jitter) { return mcguireAt(row, 20, x, {.samples = samples, .jitter = jitter}); }, 140, 180};
    lab::Picture picture = check(filter, .01);
    for (const Line& line : table)
      EXPECT_NEAR(columnMean(colorOf(picture), 160 + line.offset), samples == 15 ? line.s15 : line.s31, .01)
          << filter.what << " " << line.offset;
  }
}

TEST_F(RenderFilters, OneSidedMcGuireReproducesItsRow) {
  struct Line {
    int x;
    double value;
  };
  const Line table[] = {{145, .984}, {150, .919}, {155, .707}, {159, .007},
                        {81, .229},  {86, .523},  {91, .706},  {95, .789}};
  Row row = rasterise(kWhiteBar, 256);
  McGuire options{.samples = 15, .one_sided = true};
  RowCase filter{"one-sided", whiteBar("mcguire2012", "end", {"samples=15"}),
                 [&](int x, double jitter) {
                   options.jitter = jitter;
                   return mcguireAt(row, 20, x, options);
                 },
                 80, 160};
  lab::Picture picture = check(filter, .01);
  for (const Line& line : table) EXPECT_NEAR(columnMean(colorOf(picture), line.x), line.value, .02) << line.x;
}

// A pair of taps shares one jitter in the renderer and here.
TEST_F(RenderFilters, PairedFilterReproducesItsTable) {
  const std::pair<int, double> table[] = {{-10, .9746}, {-6, .7754}, {-4, .6748}, {-1, .5254},
                                          {0, .4746},   {2, .3750},  {5, .2246},  {8, .0752}};
  Row row = rasterise(kWhiteBar, 256);
  RowCase filter{"paired", whiteBar("ue4", "centre", {"samples=16"}),
                 [&](int x, double jitter) { return pairedAt(row, 20, x, {.samples = 16, .jitter = jitter}); }, 130,
                 190};
  lab::Picture picture = check(filter, .01);
  for (const auto& [offset, value] : table)
    EXPECT_NEAR(columnMean(colorOf(picture), 160 + offset), value, .01) << offset;
}

// Estimates the background inside a silhouette from pairs of taps; the true background is white throughout.
TEST_F(RenderFilters, PairedFilterAddsAFalseEdge) {
  Strips strips{{160, 288, 40, {.5}}, {-kInfinity, 296, 0, {1}}, {}};
  Row row = rasterise(strips, 480);
  for (Texel& texel : row) texel.depth = texel.surface == 0 ? 1 : 2;  // white and black are one surface
  for (bool mirror : {true, false}) {
    lab::Shot shot =
        with(shotOf("hidden_white", 480, kRows), "ue4",
             {"samples=32", "tile=20", "limit=0.1", "jitter=ign", fmt::format("mirror={}", mirror)}, "centre");
    RowCase filter{
        fmt::format("mirror {}", mirror), shot,
        [&](int x, double jitter) { return pairedAt(row, 40, x, {.samples = 32, .jitter = jitter, .mirror = mirror}); },
        260, 320};
    lab::Picture picture = check(filter, .01);
    const std::pair<int, double> implied[] = {{0, .4099}, {5, .5512}, {10, .8413}, {12, 1}};
    for (const auto& [s, value] : implied) {
      double covered = .5 + (s + .5) / 40;
      double behind = (columnMean(colorOf(picture), 287 - s) - .5 * covered) / (1 - covered);
      EXPECT_NEAR(behind, value, .01) << filter.what << " s " << s;
    }
    EXPECT_NEAR(columnMean(colorOf(picture), 288), mirror ? .4438 : .7563, .01) << filter.what;
  }
}

// Each of N taps counts as 1/N of the exposure or not at all. Over a static background the error is at most 1/(2N) for
// each edge, as with N time samples.
TEST_F(RenderFilters, UniformGatherIsExactOverAStaticBackground) {
  for (int samples : {16, 32}) {
    for (const Anchor& anchor : anchors()) {
      lab::Shot shot =
          with(shotOf("bar", 256, 20), "mcguire2012",
               {"weights=uniform", "tile=20", "limit=0.1", fmt::format("samples={}", samples)}, anchor.name);
      lab::Picture picture = render(shot);
      expectWithin(
          colorOf(picture), [&](int x, int) { return exposeCentre(kWhiteBar, anchor.window, x); },
          [&](const Exposure& e) { return e.variation * (1. / (2 * samples)) + 1e-4; },
          fmt::format("{} N {}", anchor.name, samples));
    }
  }
}

// Surfaces closer than `depth_extent` count partly as one. With equal motion each tap still counts once.
TEST_F(RenderFilters, UniformGatherIsABoxFilterOfSurfacesCloseInDepth) {
  constexpr int kSamples = 32;
  Strips strips{{40, 72, 16, {.9}}, {-kInfinity, kInfinity, 16, {.2}}};
  for (double behind : {-.1, -.4, -.8, -5.0}) {
    lab::Shot shot = shotOf("cards", 128, 4,
                            {{"left0", 40},
                             {"right0", 72},
                             {"z0", 0},
                             {"v0", .9},
                             {"d0", 16},
                             {"left1", -80},
                             {"right1", 208},
                             {"z1", behind},
                             {"v1", .2},
                             {"d1", 16}});
    for (const Anchor& anchor : anchors()) {
      lab::Picture picture =
          render(with(shot, "mcguire2012",
                      {"weights=uniform", "tile=20", "limit=0.2", fmt::format("samples={}", kSamples)}, anchor.name));
      expectWithin(
          colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); },
          [&](const Exposure& e) { return e.variation * (1. / (2 * kSamples) + .5 / 16) + 1e-4; },
          fmt::format("{} {}", anchor.name, behind));
    }
  }
}

}  // namespace render_filters_test
}  // namespace strobe::oracle
