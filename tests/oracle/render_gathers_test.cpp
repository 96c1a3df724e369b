// SPDX-License-Identifier: MIT
// The gathers of Guertin 2014 and Jimenez 2014 in the renderer: against the same filters in double precision, pixel by
// pixel; their tiles and paths, on scenes where these can be counted; and properties of every filter.
#include <fmt/format.h>

#include <cmath>

#include "oracle/gather_1d.h"
#include "oracle/gather_2d.h"
#include "oracle/render.h"
#include "oracle/row_case.h"

namespace strobe::oracle {
namespace render_gathers_test {

constexpr int kWidth = 256, kRows = 24;

const Strips kWhiteBar{{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}};

Strips stripes(double d_front, double d_back) {
  return {{96, 160, d_front, {.9, .6, 8, 96}}, {-kInfinity, kInfinity, d_back, {.4, .1, 8, 0}}};
}

lab::Shot rowShot(const std::string& scene, const std::string& pipeline, const std::string& anchor,
                  std::vector<std::string> settings, const Numbers& numbers = {}) {
  settings.insert(settings.begin(), {"tile=20", "limit=0.1", "jitter=ign"});
  return with(shotOf(scene, kWidth, kRows, numbers), pipeline, settings, anchor);
}

Numbers motions(double d_front, double d_back) { return {{"d_f", d_front}, {"d_b", d_back}}; }

class RenderGathers : public RenderTest {
 protected:
  void checkRow(const RowCase& filter) {
    lab::Picture picture = render(filter.shot);
    EXPECT_EQ(counterOf(picture, "tile_max.clamped"), 0u) << filter.what;
    expectPerPixel(filter, colorOf(picture));
  }
};

// --- Against the filter along a row

TEST_F(RenderGathers, GuertinMatchesTheRowFilter) {
  struct Case {
    std::string scene;
    double d_front, d_back;
    std::vector<std::string> settings;
    Guertin options;
  };
  const Case cases[] = {
      {"bar", 20, 0, {}, {}},
      {"bar", 20, 0, {"directions=one", "kappa=10", "samples=15"}, {.samples = 15, .two = false, .kappa = 10}},
      {"textured_bar", 20, 3, {}, {}},
      {"textured_bar", 20, 16, {}, {.uniform = true}},
      {"textured_bar", 20, 16, {"uniform_path=false", "eta=0.5"}, {.eta = .5}},
  };
  for (const Case& c : cases)
    for (const Anchor& anchor : anchors()) {
      Strips strips = c.scene == "bar" ? kWhiteBar : stripes(c.d_front, c.d_back);
      Row row = rasterise(strips, kWidth);
      auto dominant = dominantDisplacement({&row}, 20, anchor.window);
      Guertin options = c.options;
      options.window = anchor.window;
      Numbers numbers = c.scene == "bar" ? Numbers{} : motions(c.d_front, c.d_back);
      checkRow({fmt::format("{} {} {}", c.scene, fmt::join(c.settings, " "), anchor.name),
                rowShot(c.scene, "guertin2014", anchor.name, c.settings, numbers),
                [&](int x, double jitter) {
                  options.jitter = jitter;
                  return guertinAt(row, dominant[x], x, options);
                },
                100, 160});  // tiles on the bar's path for every anchor
    }
}

TEST_F(RenderGathers, JimenezMatchesTheRowFilter) {
  struct Case {
    std::string scene;
    double d_front, d_back;
    std::vector<std::string> settings;
    Paired options;
  };
  const Case cases[] = {
      {"bar", 20, 0, {}, {}},
      {"textured_bar", 20, 8, {"direction=projected"}, {.facing = Facing::kProjected}},
      {"textured_bar", 20, -8, {"direction=opposing", "mirror=false"}, {.mirror = false, .facing = Facing::kOpposing}},
      {"textured_bar", 9, 0, {"count=adaptive", "limit=0.05"}, {.samples = 8}},
      {"textured_bar", 20, 19, {"cheap=false"}, {}},
  };
  for (const Case& c : cases)
    for (const Anchor& anchor : anchors()) {
      Row row = rasterise(c.scene == "bar" ? kWhiteBar : stripes(c.d_front, c.d_back), kWidth);
      Paired options = c.options;
      options.window = anchor.window;
      Numbers numbers = c.scene == "bar" ? Numbers{} : motions(c.d_front, c.d_back);
      checkRow({fmt::format("{} {} {}", c.scene, fmt::join(c.settings, " "), anchor.name),
                rowShot(c.scene, "jimenez2014", anchor.name, c.settings, numbers),
                [&](int x, double jitter) {
                  options.jitter = jitter;
                  return pairedAt(row, c.d_front, x, options);
                },
                100, 160});
    }
}

// The cheap path is the plain mean of the taps, at any depth.
TEST_F(RenderGathers, JimenezAveragesRegionsOfEqualMotion) {
  Row row = rasterise(stripes(20, 19), kWidth);
  for (const Anchor& anchor : anchors()) {
    bool centred = anchor.name == "centre";
    auto mean = [&](int x, double jitter) {
      double sum = 0;
      for (int i = 0; i < 16; ++i) {
        double side = centred ? (i < 8 ? 1 : -1) : (anchor.name == "end" ? 1 : -1);
        sum += row[tapAt(x, side * 20 * ((centred ? i % 8 : i) + .5 + jitter) / 16)].colour;
      }
      return sum / 16;
    };
    checkRow({"cheap " + anchor.name, rowShot("textured_bar", "jimenez2014", anchor.name, {}, motions(20, 19)), mean,
              100, 160});
  }
}

// No more samples than pixels of motion, but at least a pair.
TEST_F(RenderGathers, JimenezTakesAtLeastAPair) {
  for (const Anchor& anchor : anchors()) {
    auto by = [&](const char* count, int samples) {
      return colorOf(
          render(rowShot("textured_bar", "jimenez2014", anchor.name,
                         {fmt::format("count={}", count), fmt::format("samples={}", samples)}, motions(1.5, 0))));
    };
    image::Image adaptive = by("adaptive", 16);
    EXPECT_TRUE(identical(adaptive, by("fixed", 2))) << anchor.name;
    EXPECT_FALSE(identical(adaptive, by("fixed", 16))) << anchor.name;
  }
}

// Every jitter, frozen and per frame. In frame 1 the bar is two displacements farther on (exposure 1/2).
TEST_F(RenderGathers, JittersMatchTheirDefinitions) {
  Row row = rasterise(kWhiteBar, kWidth);
  auto at_jitter = [&](int x, double jitter) { return pairedAt(row, 20, x, {.jitter = jitter}); };
  for (bool per_frame : {false, true}) {
    for (const auto& [name, jitter] : jittersOf(per_frame ? 1 : 0)) {
      lab::Shot shot = rowShot("bar", "jimenez2014", "centre",
                               {"jitter=" + name, fmt::format("jitter_frame={}", per_frame ? "per_frame" : "frozen")},
                               {{"left", 96 - 40}, {"right", 160 - 40}});
      shot.frame = 1;
      checkRow({fmt::format("{} {}", name, per_frame), shot, at_jitter, 130, 190, jitter});
    }
  }
}

// --- In the plane

// Gathers the rendered color, depth, velocity and tiles again in double precision. A tap within single precision of the
// border between two pixels may take either pixel: one pixel in 200 may have such a tap.
TEST_F(RenderGathers, GuertinMatchesThePlaneFilter) {
  EXPECT_NEAR(secondDirection({10, 0}, {0, 0}, {0, 3}, .5, 1.5).y, 1, 1e-12);  // static: across, to the side of `other`
  EXPECT_NEAR(secondDirection({10, 0}, {0, -9}, {}, 9, 1.5).y, -1, 1e-12);     // fast: its own direction
  Vec2d between = secondDirection({10, 0}, {-1, 1}, {}, 1.25, 1.5);            // half of each: (-.354, .854), scaled
  EXPECT_NEAR(between.x / between.y, -.5 * std::sqrt(.5) / (.5 + .5 * std::sqrt(.5)), 1e-12);

  Numbers numbers = {{"b_left", 16}, {"b_top", 24}, {"b_x", 2.25}, {"b_y", 11.5}, {"a_left", 24}, {"a_top", 40}};
  lab::Shot scene = shotOf("crossing", 96, 96, numbers);
  image::Image color = colorOf(render(with(scene, "none")));
  for (const char* share : {"half", "variance"})
    for (const Anchor& anchor : anchors()) {
      lab::Shot shot = with(scene, "guertin2014",
                            {"tile=16", "limit=0.2", "jitter=ign", fmt::format("second_share={}", share)}, anchor.name);
      shot.taps = {"neighbour_max.dominant", "neighbour_max.second"};
      bool by_variance = share == std::string("variance");
      if (by_variance) shot.taps.push_back("direction_variance.variance");
      lab::Picture picture = render(shot);
      auto tapped = [&](const std::string& name) { return &picture.frame.taps.at(name).floats; };
      Plane plane{&color,
                  &imageOf(picture, "depth"),
                  &imageOf(picture, "velocity"),
                  tapped(shot.taps[0]),
                  tapped(shot.taps[1]),
                  by_variance ? tapped(shot.taps[2]) : nullptr,
                  16};
      int off = 0, blurred = 0;
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
          double value = colorOf(picture).at(x, y, 0), nearest = kInfinity;
          for (double shift : {0., -2e-4, 2e-4}) {
            PlaneGuertin options{.jitter = ignJitter(x, y) + shift, .window = anchor.window};
            nearest = std::min(nearest, std::abs(value - guertinAt(plane, x, y, options)));
          }
          off += nearest > 2e-3;
          blurred += std::abs(value - color.at(x, y, 0)) > .01;
        }
      EXPECT_LE(off, 96 * 96 / 200) << share << " " << anchor.name;
      EXPECT_GE(blurred, 500) << share << " " << anchor.name;
    }
}

// --- Tiles

// One tile of 32 px moves by u and lies at `offset` from the middle tile; the middle tile is tested.
TEST_F(RenderGathers, TilesCountByTheDirectionOfTheirMotion) {
  struct Case {
    int offset_x, offset_y;
    double u_x, u_y;
    bool centre, close, open;
  };
  const Case cases[] = {
      {-1, -1, 6, -12, false, false, false},  // published: rejected
      {-1, -1, -6, -12, true, true, false},   // published: accepted
      {-1, -1, 6, 12, true, false, true},    {-1, 0, 6, -12, true, false, true}, {-1, 0, 0, 12, false, false, false},
      {0, 1, 6, 12, true, true, false},      {1, -1, 12, -6, true, true, false}, {0, 0, 6, 12, true, true, true},
  };
  for (const Case& c : cases)
    for (const Anchor& anchor : anchors()) {
      Numbers numbers = {{"a_left", 32 * (1 + c.offset_x)},
                         {"a_top", 32 * (1 + c.offset_y)},
                         {"a_x", c.u_x},
                         {"a_y", c.u_y},
                         {"b_y", 0}};
      bool expected = anchor.name == "centre" ? c.centre : anchor.name == "end" ? c.close : c.open;
      for (const char* rule : {"sign", "swept_box"}) {
        if (rule == std::string("swept_box") && anchor.name == "start") continue;  // the mirror image of `end`
        lab::Shot shot = with(shotOf("crossing", 96, 96, numbers), "mcguire2012",
                              {"tile=32", "limit=0.3", fmt::format("tile_rule={}", rule)}, anchor.name);
        shot.taps = {"neighbour_max.dominant"};
        lab::Picture picture = render(shot);
        double length = std::hypot(picture.frame.taps.at("neighbour_max.dominant").floats.at(1, 1, 0),
                                   picture.frame.taps.at("neighbour_max.dominant").floats.at(1, 1, 1));
        EXPECT_NEAR(length, expected ? std::hypot(c.u_x, c.u_y) : 0, 1e-3)
            << rule << " " << anchor.name << " " << c.offset_x << " " << c.offset_y << " " << c.u_x << " " << c.u_y;
      }
    }
}

// Two adjacent tiles move, seven are static: 1 - (1 + |cos|) / 2 for the two and for static tiles beside both.
TEST_F(RenderGathers, TileVarianceIsOneMinusTheMeanAlignment) {
  struct Case {
    double x, y, cosine;
  };
  for (const Case& c : {Case{0, 10, 0}, Case{7, 7, std::sqrt(.5)}, Case{-10, 0, 1}, Case{6, -8, .6}}) {
    lab::Shot shot = with(shotOf("crossing", 96, 96, {{"b_x", c.x}, {"b_y", c.y}}), "guertin2014",
                          {"tile=32", "limit=0.3", "tile_rule=all", "second_share=variance"});
    shot.taps = {"direction_variance.variance"};
    image::Image variance = render(shot).frame.taps.at("direction_variance.variance").floats;
    double both = 1 - (1 + c.cosine) / 2;
    // The right column is beside b only, the bottom row beside neither tile.
    const double expected[3][3] = {{both, both, 0}, {both, both, 0}, {0, 0, 0}};
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        EXPECT_NEAR(variance.at(x, y, 0), expected[y][x], 1e-5) << c.x << " " << c.y << " at " << x << " " << y;
  }
}

// Displacements are read at most a quarter of a tile away: only pixels within that distance of a tile's border can
// change.
TEST_F(RenderGathers, TileJitterStaysWithinAQuarterOfATile) {
  auto color = [&](const std::string& tile_jitter) {
    return colorOf(render(rowShot("bar", "guertin2014", "end", {"jitter=none", "tile_jitter=" + tile_jitter})));
  };
  image::Image own = color("none");
  for (const char* choice : {"angle", "axis"}) {
    image::Image other = color(choice);
    int changed = 0;
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (other.at(x, y, 0) == own.at(x, y, 0)) continue;
        ++changed;
        double to_border = std::abs(x + .5 - 20 * std::round((x + .5) / 20));
        EXPECT_LE(to_border, 5) << choice << " " << x;
      }
    EXPECT_GT(changed, 0) << choice;
  }
}

// A pixel beside a rectangle that moves vertically. The dominant motion, of a distant rectangle, is horizontal: the
// surfaces at the taps never reach the pixel.
TEST_F(RenderGathers, DirectionWeightsRejectMotionAcrossTheTaps) {
  lab::Shot scene = shotOf("crossing", 96, 96,
                           {{"b_left", 24},
                            {"b_top", 24},
                            {"b_y", 11},
                            {"a_left", 40},
                            {"a_top", 24},
                            {"a_width", 8},
                            {"a_height", 64},
                            {"a_x", 14}});
  auto beside = [&](const std::string& direction) {
    lab::Shot shot = with(scene, "jimenez2014", {"tile=16", "limit=0.2", "direction=" + direction}, "end");
    return colorOf(render(shot)).at(22, 40, 0);
  };
  EXPECT_GT(beside("none"), .3);
  EXPECT_NEAR(beside("cosine"), .2, 1e-6);
  EXPECT_NEAR(beside("projected"), .2, 1e-6);
}

// --- Paths

// The bar's tiles are the columns [80, 160), so within the exposure the bar stays in [60, 180). Only around the tile
// [120, 140) do all tiles have equal motion, for any background.
TEST_F(RenderGathers, PathsHaveTheExpectedPixelCounts) {
  struct Case {
    std::string pipeline, scene;
    Numbers numbers;
    std::vector<std::pair<std::string, int>> columns;
  };
  const Case cases[] = {
      {"jimenez2014", "bar", {}, {{"copied", 136}, {"cheap", 20}, {"full", 100}}},
      {"jimenez2014", "textured_bar", motions(20, 19), {{"copied", 0}, {"cheap", 256}, {"full", 0}}},
      {"jimenez2014", "textured_bar", motions(20, 17), {{"copied", 0}, {"cheap", 156}, {"full", 100}}},
      {"guertin2014", "bar", {}, {{"copied", 136}, {"uniform", 20}}},
      {"guertin2014", "textured_bar", motions(20, 16), {{"copied", 0}, {"uniform", 256}}},
      {"guertin2014", "textured_bar", motions(7, 7), {{"copied", 0}, {"uniform", 0}}},  // 3.5 px: too short
      {"guertin2014", "textured_bar", motions(1, 1), {{"copied", 256}, {"uniform", 0}}},
  };
  for (const Case& c : cases) {
    lab::Picture picture = render(rowShot(c.scene, c.pipeline, "centre", {}, c.numbers));
    for (const auto& [path, columns] : c.columns)
      EXPECT_EQ(counterOf(picture, "gather." + path), uint64_t(columns * kRows)) << c.pipeline << " " << path;
  }
}

// --- Over a revealed layer

// Under alpha_over a gather returns the foreground alone where a surface was revealed. Over a static background a
// composite with exact coverage is exact: to 16 samples in the inner band, with taps rounded to pixels. Weights that
// are too opaque stay too opaque.
TEST_F(RenderGathers, GathersSeparateForegroundAndRevealedLayer) {
  Strips strips = stripes(20, 0);
  auto inner_error = [&](const std::string& weights) {
    lab::Shot shot = with(shotOf("textured_bar", kWidth, 8), hybridSteps(),
                          {"composite=alpha_over", "tile=20", "limit=0.1", "weights=" + weights}, "end");
    image::Image color = colorOf(render(shot));
    double worst = 0;
    for (int x = 140; x < 160; ++x)
      worst = std::max(worst, std::abs(color.at(x, 4, 0) - exposeCentre(strips, kCloseAnchor, x).colour));
    return worst;
  };
  double exact = inner_error("jimenez2014"), opaque = inner_error("guertin2014");
  EXPECT_LE(exact, .8 / 32 + 1e-4);  // changes of .8 at most: stripes and the edge
  EXPECT_GT(opaque, 5 * exact);
  EXPECT_LT(opaque, .3);  // at most .5 too opaque, over a background darker by .5 on average
}

// A static surface before a moving background is visible throughout the exposure, wherever the taps fall.
TEST_F(RenderGathers, StaticForegroundsAreKept) {
  for (const char* samples : {"samples=5", "samples=16"}) {
    lab::Shot shot = shotOf("textured_bar", kWidth, 8, motions(0, 20));
    image::Image seen = colorOf(render(with(shot, "none", {}, "end")));
    image::Image color = colorOf(render(
        with(shot, hybridSteps(), {"composite=alpha_over", "mask=all", "tile=20", "limit=0.1", samples}, "end")));
    for (int x = 96; x < 160; ++x) EXPECT_NEAR(color.at(x, 4, 0), seen.at(x, 4, 0), 1e-6) << samples << " " << x;
  }
}

// A static wire keeps its colour before moving objects, also if no tap falls on the wire.
TEST_F(RenderGathers, ThinStaticForegroundsKeepTheirColour) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"mcguire2012", {"weights=uniform"}}, {"hybrid", {}}, {"hybrid_layered", {}}, {"adaptive", {}}};
  for (double width : {1, 2, 5})
    for (double d : {3, 11, 24})
      for (const auto& [pipeline, settings] : cases)
        for (const Anchor& anchor : anchors()) {
          const Numbers numbers = {{"left0", 60}, {"right0", 60 + width}, {"v0", .9}, {"z0", 5},
                                   {"left1", 40}, {"right1", 80},         {"v1", .5}, {"d1", d}};
          const lab::Shot shot = with(shotOf("cards", 128, 8, numbers), pipeline, settings, anchor.name);
          const image::Image color = colorOf(render(shot));
          for (int x = 60; x < 60 + int(width); ++x)
            EXPECT_NEAR(color.at(x, 4, 0), .9, 1e-6)
                << pipeline << " " << anchor.name << " " << width << " " << d << " " << x;
        }
}

}  // namespace render_gathers_test
}  // namespace strobe::oracle
