// SPDX-License-Identifier: MIT
// Truth against exact exposures. M time samples of a step function of time with changes J_1 ... J_m are off by at most
// sum |J| / (2M) at the midpoints of M strata, and by sum |J| / M anywhere in the strata (docs/derivations.md); 1e-4 is
// for single precision. Rasterisation snaps vertices to 1/256 px, which moves a crossing by 1/(256 |d|) of the
// exposure. The tests catch wrong times, weights or filters of samples; differences between rasterisation and rays; and
// skipped rays (SkipsRays..., SamplesStaticPixelsOnce) that would have changed a pixel, one test for each reason to
// skip rays.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/all_cases.h"
#include "common/refusal.h"
#include "oracle/gather_1d.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_truth_test {

constexpr double kRounding = 1e-4;

BoundOf midpointBound(int samples) {
  return [=](const Exposure& e) { return e.variation / (2 * samples) + kRounding; };
}
BoundOf strataBound(int samples) {
  return [=](const Exposure& e) { return e.variation / samples + kRounding; };
}

// A small scene of a striped bar over stripes, both moving; all rows are equal.
struct StripedScene {
  double d_front = 20, d_back = -12;
  lab::Shot shot() const {
    return shotOf("textured_bar", 112, 4,
                  {{"left", 32}, {"right", 80}, {"d_f", d_front}, {"d_b", d_back}, {"period_f", 6}, {"period_b", 10}});
  }
  ExactAt exact(Window window) const {
    Strips strips{{32, 80, d_front, {.9, .6, 6, 32}}, {-kInfinity, kInfinity, d_back, {.4, .1, 10, 0}}};
    return [=](int x, int) { return exposeCentre(strips, window, x); };
  }
};

std::vector<std::string> truth(int samples, std::vector<std::string> more = {}) {
  more.push_back(fmt::format("samples={}", samples));
  return more;
}

class RenderTruth : public RenderTest {};

TEST_F(RenderTruth, HalfPlaneAndBarMatchTheirCoverage) {
  constexpr int kSamples = 256;
  for (const Anchor& anchor : anchors()) {
    for (double d : {20.0, -7.25, 0.3}) {
      lab::Shot plane = shotOf("half_plane", 96, 2, {{"edge", 48.3}, {"d_f", d}});
      lab::Shot bar = shotOf("bar", 96, 2, {{"left", 40.3}, {"right", 45.8}, {"d_f", d}});
      Strips plane_strips{{-kInfinity, 48.3, d, {1}}, {}}, bar_strips{{40.3, 45.8, d, {1}}, {}};
      for (const auto& [shot, strips] : {std::pair(plane, plane_strips), std::pair(bar, bar_strips)}) {
        lab::Picture picture = render(with(shot, "ground_truth", truth(kSamples), anchor.name));
        expectWithin(
            colorOf(picture), [&, &strips = strips](int x, int) { return exposeCentre(strips, anchor.window, x); },
            midpointBound(kSamples), fmt::format("{} d {}", anchor.name, d));
      }
    }
  }
}

// A bar in front at the raster time uncovers the background that it hid (inner, hidden) and covers the background
// beside it (outer).
TEST_F(RenderTruth, RegionsFollowTheMotionOfTheBar) {
  constexpr int kSamples = 32, kLeft = 40, kRight = 60, kMoved = 20;
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(shotOf("bar", 96, 2, {{"left", kLeft}, {"right", kRight}, {"d_f", kMoved}}),
                                       "ground_truth", truth(kSamples), anchor.name));
    for (int x = 0; x < 96; ++x) {
      auto covered = [&](double t) {
        double at = x + .5 - kMoved * t;
        return at >= kLeft && at < kRight;
      };
      bool now = covered(0), seen_away = false, seen_there = false;
      for (int i = 0; i < kSamples; ++i) {
        double t = anchor.window.open + (i + .5) / kSamples * (anchor.window.close - anchor.window.open);
        (covered(t) ? seen_there : seen_away) = true;
      }
      auto marked = [&](const char* region) { return imageOf(picture, region).at(x, 0, 0) > .5f; };
      std::string what = fmt::format("{} column {}", anchor.name, x);
      EXPECT_EQ(marked("inner"), now && seen_away) << what;
      EXPECT_EQ(marked("hidden"), now && seen_away) << what;
      EXPECT_EQ(marked("outer"), !now && seen_there) << what;
    }
  }
}

// One sample lies at the raster time, where a moving surface hides the background that it uncovers at other times.
TEST_F(RenderTruth, OddNumbersOfSamplesMatch) {
  for (int samples : {1, 3, 5, 33}) {
    for (double d : {20.0, -7.25}) {
      lab::Shot shot = shotOf("half_plane", 96, 2, {{"edge", 48.3}, {"d_f", d}});
      Strips strips{{-kInfinity, 48.3, d, {1}}, {}};
      expectWithin(
          colorOf(render(with(shot, "ground_truth", truth(samples), "centre"))),
          [&](int x, int) {
            return exposeCentre(strips, {-.5, .5}, x);
          },
          midpointBound(samples), fmt::format("{} samples, d {}", samples, d));
    }
  }
}

TEST_F(RenderTruth, TexturedBarMatchesAtMidpointsAndInStrata) {
  constexpr int kSamples = 128;
  for (const Anchor& anchor : anchors()) {
    for (StripedScene scene : {StripedScene{20, -12}, {0, 20}, {6, 20}, {-11, -11}}) {
      std::string what = fmt::format("{} f {} b {}", anchor.name, scene.d_front, scene.d_back);
      lab::Picture midpoints = render(with(scene.shot(), "ground_truth", truth(kSamples), anchor.name));
      expectWithin(colorOf(midpoints), scene.exact(anchor.window), midpointBound(kSamples), what);
      lab::Picture strata =
          render(with(scene.shot(), "ground_truth", truth(kSamples, {"times=stratified"}), anchor.name));
      expectWithin(colorOf(strata), scene.exact(anchor.window), strataBound(kSamples), what + " stratified");
      EXPECT_FALSE(identical(colorOf(midpoints), colorOf(strata))) << what;
    }
  }
}

// A pinhole camera with surfaces at two depths.
TEST_F(RenderTruth, PerspectiveMatches) {
  constexpr int kSamples = 256;
  Strips strips{{20, 60, 15, {.8}}, {-kInfinity, 50, -6, {.3}}, {-kInfinity, kInfinity, 0, {.1}}};
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(shotOf("pinhole", 96, 4), "ground_truth", truth(kSamples), anchor.name));
    expectWithin(
        colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); }, midpointBound(kSamples),
        anchor.name);
  }
}

// Sides and motion oblique to the axes, over a moving checker.
TEST_F(RenderTruth, SlantedQuadOverAMovingCheckerMatches) {
  constexpr int kSamples = 256;
  MovingPolygon quad{
      {{20.3, 12.1}, {50.2, 16.8}, {45.9, 40.4}, {17.6, 33.3}}, {11.5, -6.25}, {.8}, {-3.5, 2.25}, {.4, .1, 8, 0, 0}};
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(shotOf("slanted_quad", 72, 56), "ground_truth", truth(kSamples), anchor.name));
    expectWithin(
        colorOf(picture), [&](int x, int y) { return exposeCentre(quad, anchor.window, x, y); },
        midpointBound(kSamples), anchor.name);
  }
}

// Poses rotate; points do not move along straight lines.
TEST_F(RenderTruth, TurningWedgeMatches) {
  constexpr int kSamples = 256, kSide = 48;
  for (double degrees : {30.0, -160.0}) {
    lab::Shot shot = shotOf("wedge", kSide, kSide, {{"from", 20}, {"to", 65}, {"degrees", degrees}});
    RotatingPolygon wedge{{{kSide / 2., kSide / 2.}}, {kSide / 2., kSide / 2.}};
    wedge.angle = -degrees * std::numbers::pi / 180;  // y points down
    for (double direction : {20.0, 42.5, 65.0}) {
      double phi = direction * std::numbers::pi / 180, radius = 4 * kSide;
      wedge.corners.push_back({kSide / 2. + radius * std::cos(phi), kSide / 2. - radius * std::sin(phi)});
    }
    for (const Anchor& anchor : anchors()) {
      lab::Picture picture = render(with(shot, "ground_truth", truth(kSamples), anchor.name));
      expectWithin(
          colorOf(picture), [&](int x, int y) { return exposeCentre(wedge, anchor.window, x, y); },
          midpointBound(kSamples), fmt::format("{} {} degrees", anchor.name, degrees));
    }
  }
}

TEST_F(RenderTruth, BoxPixelsMatchWithinTheirStatedError) {
  Strips strips{{32, 80, 20, {.9, .6, 6, 32}}, {-kInfinity, kInfinity, -12, {.4, .1, 10, 0}}};
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(
        with(StripedScene{20, -12}.shot(), "ground_truth", truth(64, {"pixel=box", "times=stratified"}), anchor.name));
    double sum = 0;
    const image::Image& color = colorOf(picture);
    for (int y = 0; y < color.height; ++y)
      for (int x = 0; x < color.width; ++x)
        sum += std::pow(color.at(x, y, 0) - exposePixel(strips, anchor.window, x).colour, 2);
    double error = std::sqrt(sum / (color.width * color.height)), stated = rms(imageOf(picture, "error"));
    EXPECT_LE(error, 3 * stated) << anchor.name;
    EXPECT_LE(stated, .03) << anchor.name;  // the stated error is small, too
  }
}

// The mean over seeds tends to the exact value. The deviation of sixteen seeds is a quarter of the bound for one seed,
// sqrt(sum J^2) / (2M); four deviations plus 1e-4 are never exceeded by chance.
TEST_F(RenderTruth, JitteredTimesAreUnbiased) {
  constexpr int kSamples = 64, kSeeds = 16;
  StripedScene scene;
  image::Image mean;
  for (int seed = 0; seed < kSeeds; ++seed) {
    lab::Shot shot = with(scene.shot(), "ground_truth", truth(kSamples, {"times=stratified"}));
    shot.seed = uint32_t(seed + 1);
    lab::Picture picture = render(shot);
    if (seed == 0) mean = image::Image(colorOf(picture).width, colorOf(picture).height, 4);
    for (size_t i = 0; i < mean.values.size(); ++i) mean.values[i] += colorOf(picture).values[i] / kSeeds;
  }
  expectWithin(
      mean, scene.exact(kCloseAnchor),
      [](const Exposure& e) { return std::sqrt(e.variation * e.jump) / (2 * kSamples) + kRounding; }, "mean");
}

// The stated error is the error of the mean, up to the noise of an estimate from half the samples.
TEST_F(RenderTruth, StatedErrorMatchesTheActualError) {
  constexpr int kSamples = 64;
  StripedScene scene;
  double made = 0, stated = 0;
  for (uint32_t seed = 1; seed <= 8; ++seed) {
    lab::Shot shot = with(scene.shot(), "ground_truth", truth(kSamples, {"times=stratified"}));
    shot.seed = seed;
    lab::Picture picture = render(shot);
    const image::Image& color = colorOf(picture);
    for (int x = 0; x < color.width; ++x)
      made += std::pow(color.at(x, 1, 0) - scene.exact(kCloseAnchor)(x, 1).colour, 2) / color.width;
    stated += std::pow(rms(imageOf(picture, "error")), 2);
    EXPECT_EQ(imageOf(picture, "error").at(50, 1, 3), kSamples);
  }
  double ratio = std::sqrt(stated / made);
  RecordProperty("stated_over_made", fmt::format("{:.3f}", ratio));
  EXPECT_GE(ratio, 0.7);
  EXPECT_LE(ratio, 3);
}

// One sample gives no estimate of its error.
TEST_F(RenderTruth, OneSampleStatesNoError) {
  lab::Picture picture = render(with(shotOf("bar", 96, 2, {{"d_f", 20}}), "ground_truth", truth(1)));
  for (int x = 0; x < 96; ++x)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(imageOf(picture, "error").at(x, 0, c), c < 3 ? 0 : 1) << x;
}

TEST_F(RenderTruth, NothingIsClamped) {
  constexpr int kSamples = 512;
  Strips strips{{40, 56, 300, {1}}, {}};
  lab::Shot shot = shotOf("bar", 96, 2, {{"left", 40}, {"right", 56}, {"d_f", 300}});
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(shot, "ground_truth", truth(kSamples), anchor.name));
    expectWithin(
        colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); }, midpointBound(kSamples),
        anchor.name);
    EXPECT_NEAR(imageOf(picture, "velocity").at(48, 0, 0), 300, 1e-3) << anchor.name;
  }
}

TEST_F(RenderTruth, StopsAtTheToleranceAndNotBefore) {
  lab::Shot shot = StripedScene{}.shot();
  lab::Picture all = render(with(shot, "ground_truth", truth(256, {"times=stratified"})));
  auto samplesOf = [](const lab::Picture& picture) {
    return iterationsOf(picture, "first") + iterationsOf(picture, "shutter");
  };
  EXPECT_EQ(samplesOf(all), 256);
  EXPECT_EQ(imageOf(all, "error").at(50, 1, 3), 256);

  lab::Picture some = render(with(shot, "ground_truth", truth(1024, {"times=stratified", "tolerance=0.003"})));
  int count = samplesOf(some);
  EXPECT_GE(count, 64);
  EXPECT_LT(count, 1024);
  EXPECT_EQ(imageOf(some, "error").at(50, 1, 3), count);
  EXPECT_LE(rms(imageOf(some, "error")), .003);
  // The missing samples are spread over the exposure instead of left out at its end.
  EXPECT_LE(rmsDifference(colorOf(some), colorOf(all)), 2 * .003);

  lab::Picture strict = render(with(shot, "ground_truth", truth(128, {"times=stratified", "tolerance=1e-6"})));
  EXPECT_EQ(samplesOf(strict), 128);
}

// Rasterised pictures at the same times share no visibility with rays. They differ only where a sample falls within
// 1/256 px of an edge: at most by the snapping, and on average by less than the stated error.
TEST_F(RenderTruth, RasterAndRaysAgree) {
  constexpr int kSamples = 64;
  for (StripedScene scene : {StripedScene{20, -12}, {6, 20}}) {
    for (const Anchor& anchor : anchors()) {
      std::string what = fmt::format("{} f {} b {}", anchor.name, scene.d_front, scene.d_back);
      lab::Picture rays = render(with(scene.shot(), "ground_truth", truth(kSamples), anchor.name));
      lab::Picture raster = render(with(scene.shot(), "ground_truth", truth(kSamples, {"mode=raster"}), anchor.name));
      double slowest = std::min(std::abs(scene.d_front), std::abs(scene.d_back));
      expectWithin(
          colorOf(raster), scene.exact(anchor.window),
          [&](const Exposure& e) { return e.variation * (1. / (2 * kSamples) + 1 / (256 * slowest)) + kRounding; },
          what);
      EXPECT_LE(rmsDifference(colorOf(raster), colorOf(rays)), rms(imageOf(rays, "error")) + 1e-6) << what;
      EXPECT_LE(rmsDifference(imageOf(raster, "error"), imageOf(rays, "error")), .1 * rms(imageOf(rays, "error")))
          << what;
      EXPECT_EQ(
          counterOf(raster,
                    "sample_shade.rays_" +
                        bench().render(with(scene.shot(), "none")).record["device"]["backend"].get<std::string>()),
          0u);
    }
  }
}

// Pixels that no motion reaches are not sampled again: the picture, errors and regions are equal, bit for bit.
TEST_F(RenderTruth, SamplesStaticPixelsOnce) {
  lab::Shot shot;
  shot.scene = "living_room";
  shot.width = 96;
  shot.height = 54;
  for (const char* times : {"midpoint", "stratified"}) {
    SCOPED_TRACE(times);
    std::vector<std::string> settings = {"samples=9", fmt::format("times={}", times)};
    lab::Picture once = render(with(shot, "ground_truth", settings));
    settings.insert(settings.end(), {"truth_first.static_once_per_loop=false", "sample.static_once_per_loop=false"});
    lab::Picture always = render(with(shot, "ground_truth", settings));
    for (const char* output : {"color", "error", "inner", "hidden", "outer"})
      EXPECT_TRUE(identical(imageOf(once, output), imageOf(always, output))) << output;
    EXPECT_GT(rmsDifference(colorOf(once), colorOf(render(with(shot, "none")))), 0.005);
  }
}

uint64_t sum(const lab::Picture& picture, const std::string& counter) {
  uint64_t total = 0;
  for (const auto& [name, value] : picture.record.at("counters").items())
    if ((name.starts_with("truth_") || name.starts_with("sample.")) && name.find(counter) != std::string::npos)
      total += value.get<uint64_t>();
  return total;
}

// Static surfaces are found once, and moving surfaces are traced before them. At pixel centres the picture equals the
// picture of all rays, bit for bit, with any backend. The scene has a mover in front, one behind a static surface, and
// shadows of both.
TEST_F(RenderTruth, SkipsRaysWithoutChange) {
  lab::Shot shot;
  shot.scene = "living_room";
  shot.width = 96;
  shot.height = 54;
  for (const char* backend : {"query", "pipeline", "bvh"}) {
    SCOPED_TRACE(backend);
    shot.backend = backend;
    lab::Picture spared = render(with(shot, "ground_truth", truth(24)));
    lab::Picture all = render(with(shot, "ground_truth", truth(24, {"mode=brute"})));
    for (const char* output : {"color", "error", "inner", "outer"})
      EXPECT_TRUE(identical(imageOf(spared, output), imageOf(all, output))) << output;
    EXPECT_LT(sum(spared, "rays_") * 4, sum(all, "rays_"));
    EXPECT_GT(sum(spared, "validated"), 0u) << "shadows on moving surfaces";
    EXPECT_EQ(sum(all, "validated"), 0u);
  }
}

// Over whole pixels a ray is skipped only if its neighbours agree. Validation finds mismatches in less than a
// thousandth of the samples, and their error is far below the noise of this number of samples.
TEST_F(RenderTruth, SkipsRaysWhereNeighboursAgree) {
  lab::Shot shot;
  shot.scene = "living_room";
  shot.width = 160;
  shot.height = 90;
  lab::Picture spared = render(with(shot, "ground_truth", truth(64, {"pixel=box", "validation_share=0.1"})));
  lab::Picture all = render(with(shot, "ground_truth", truth(64, {"pixel=box", "mode=brute"})));
  EXPECT_LE(rmsDifference(colorOf(spared), colorOf(all)), .2 * rms(imageOf(all, "error")));
  EXPECT_GT(sum(spared, "validated"), 1000u);
  EXPECT_LE(sum(spared, "mismatched") * 1000, sum(spared, "validated"));
  EXPECT_LT(sum(spared, "rays_") * 4, sum(all, "rays_") * 3);

  if (!allCases()) return;
  // Moving shadows are sampled throughout the exposure.
  std::vector<std::string> full = truth(64, {"pixel=box", "shading=full", "validation_share=0"});
  lab::Picture lit = render(with(shot, "ground_truth", full));
  full.push_back("mode=brute");
  EXPECT_LE(rmsDifference(colorOf(lit), colorOf(render(with(shot, "ground_truth", full)))),
            .02 * rms(imageOf(lit, "error")));
}

// A rigid bar moves in front of everything. Where the bar hides every static surface, rays are traced against the bar
// alone; no part of the bar is ever hidden, and beside the bar nothing moves.
TEST_F(RenderTruth, SkipsRaysBesideARigidMover) {
  const lab::Shot bar = shotOf("bar", 96, 32, {{"left", 20}, {"right", 60}, {"d_f", 12}});
  lab::Picture spared = render(with(bar, "ground_truth", truth(64, {"pixel=box", "validation_share=0.1"})));
  lab::Picture all = render(with(bar, "ground_truth", truth(64, {"pixel=box", "mode=brute"})));
  for (const char* output : {"color", "inner", "hidden", "outer", "self"})
    EXPECT_TRUE(identical(imageOf(spared, output), imageOf(all, output))) << output;
  EXPECT_GT(sum(spared, "validated"), 1000u);
  EXPECT_EQ(sum(spared, "mismatched"), 0u);
  EXPECT_LT(sum(spared, "rays_") * 2, sum(all, "rays_"));
}

// A moving camera: the first samples show which points are visible in the raster image, and rays to these points are
// skipped.
TEST_F(RenderTruth, SkipsRaysToPointsOfTheRasterImage) {
  lab::Shot shot;
  shot.scene = "living_room";
  shot.width = 160;
  shot.height = 90;
  shot.path = {"0=0.5,1.2,2.5,0,0.8,0", "1=0.3,1.2,2.5,0,0.8,0"};
  for (const char* pixel : {"pixel=box", "pixel=centre"}) {
    if (!allCases() && pixel == std::string("pixel=centre")) continue;
    lab::Picture spared = render(with(shot, "ground_truth", truth(64, {pixel, "validation_share=0.1"})));
    lab::Picture all = render(with(shot, "ground_truth", truth(64, {pixel, "mode=brute"})));
    EXPECT_LE(rmsDifference(colorOf(spared), colorOf(all)), .2 * rms(imageOf(all, "error"))) << pixel;
    for (const char* region : {"inner", "hidden", "outer", "self"})
      EXPECT_LE(rmsDifference(imageOf(spared, region), imageOf(all, region)), .01) << pixel << ", " << region;
    EXPECT_GT(sum(spared, "validated"), 1000u) << pixel;
    EXPECT_LE(sum(spared, "mismatched") * 1000, sum(spared, "validated")) << pixel;
    EXPECT_LT(sum(spared, "rays_") * 4, sum(all, "rays_") * 3) << pixel;
  }
  // With few samples, or with full shading, no ray is skipped: both pictures trace the same rays.
  for (const char* pixel : {"pixel=box", "pixel=centre"})
    EXPECT_TRUE(identical(colorOf(render(with(shot, "ground_truth", truth(16, {pixel})))),
                          colorOf(render(with(shot, "ground_truth", truth(16, {pixel, "mode=brute"}))))))
        << pixel;
  std::vector<std::string> full = truth(16, {"pixel=box", "shading=full"});
  lab::Picture lit = render(with(shot, "ground_truth", full));
  full.push_back("mode=brute");
  EXPECT_TRUE(identical(colorOf(lit), colorOf(render(with(shot, "ground_truth", full)))));
}

// A wedge that turns, and a card that approaches.
TEST_F(RenderTruth, RasterAndRaysAgreeOnNonlinearMotion) {
  for (const char* scene : {"wedge", "approach"}) {
    lab::Shot shot = shotOf(scene, 32, 32);
    if (scene == std::string("approach")) shot.sets.clear();
    const lab::Picture rays = render(with(shot, "ground_truth", truth(64)));
    const lab::Picture raster = render(with(shot, "ground_truth", truth(64, {"mode=raster"})));
    EXPECT_GT(rmsDifference(colorOf(rays), colorOf(render(with(shot, "none")))), .05) << scene;
    EXPECT_LE(rmsDifference(colorOf(raster), colorOf(rays)), rms(imageOf(rays, "error")) + 1e-6) << scene;
  }
}

TEST_F(RenderTruth, RasterModeRefusesOptionsOfRays) {
  for (const char* setting : {"pixel=box", "slices=4"}) {
    const std::string refused = testing::refusalOf([&] {
      render(with(StripedScene{}.shot(), "ground_truth", {"mode=raster", setting}));
    });
    EXPECT_NE(refused.find("needs mode = rays"), std::string::npos) << setting << refused;
  }
}

}  // namespace render_truth_test
}  // namespace strobe::oracle
