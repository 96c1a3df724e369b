// SPDX-License-Identifier: MIT
// The row gathers against the tables in docs/derivations.md. Each number of a table is a mean over all jitters or uses
// no jitter, so it has no noise.
#include "oracle/gather_1d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "oracle/printed.h"

namespace strobe::oracle {
namespace gather_1d_test {

double overJitters(const std::function<double(double)>& at_jitter) {
  auto jitters = meanJitters();
  double sum = 0;
  for (double jitter : jitters) sum += at_jitter(jitter);
  return sum / jitters.size();
}

// A white bar [96, 160) that moves right by 20 px over black.
Strips whiteBar() { return {{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}}; }

// Half a unit in the last digit of the tables.
constexpr double kFourDigits = 0.5e-4 + 1e-9, kThreeDigits = 0.5e-3 + 1e-9;

TEST(Gather, WeightPrimitives) {
  EXPECT_NEAR(cone(3, 10), 0.7, 1e-12);
  EXPECT_EQ(cone(12, 10), 0);
  double expected[] = {1, 0.84375, 0.5, 0.15625, 0};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(cylinder(9.5 + 0.25 * i, 10), expected[i], 1e-12);
  EXPECT_EQ(softDepth(1, 1, 0.1), 1);
  EXPECT_EQ(softDepth(1, 0.5, 0.1), 1);
  EXPECT_NEAR(softDepth(1, 1.05, 0.1), 0.5, 1e-12);
  EXPECT_EQ(softDepth(1, 1.2, 0.1), 0);
}

TEST(Gather, TapsRoundSymmetrically) {
  EXPECT_EQ(tapAt(10, 2.5), 13);
  EXPECT_EQ(tapAt(10, -2.5), 7);
  EXPECT_EQ(tapAt(10, -0.4), 10);
}

struct CentredRow {
  int offset;  // from the leading edge
  double truth, mcguire_15, mcguire_31, paired_16;
};

TEST(Gather, CentredFiltersOnTheWhiteBar) {
  constexpr CentredRow kTable[] = {
      {-10, .9750, 1.0000, 1.0000, .9746}, {-6, .7750, .9775, .9785, .7754}, {-4, .6750, .9459, .9494, .6748},
      {-1, .5250, .8576, .8642, .5254},    {0, .4750, .6355, .6404, .4746},  {2, .3750, .5259, .5343, .3750},
      {5, .2250, .2810, .3082, .2246},     {8, .0750, .0335, .0499, .0752},
  };
  Strips strips = whiteBar();
  Row row = rasterise(strips, 320);
  auto dominant = dominantDisplacement({&row}, 20, kCentreAnchor);
  for (const CentredRow& expected : kTable) {
    int x = 160 + expected.offset;
    auto mcguire = [&](int samples) {
      return overJitters([&](double j) { return mcguireAt(row, dominant[x], x, {.samples = samples, .jitter = j}); });
    };
    double paired = overJitters([&](double j) { return pairedAt(row, dominant[x], x, {.samples = 16, .jitter = j}); });
    EXPECT_NEAR(exposePixel(strips, kCentreAnchor, x).colour, expected.truth, 1e-9) << expected.offset;
    EXPECT_NEAR(mcguire(15), expected.mcguire_15, kFourDigits) << expected.offset;
    EXPECT_NEAR(mcguire(31), expected.mcguire_31, kFourDigits) << expected.offset;
    EXPECT_NEAR(paired, expected.paired_16, kFourDigits) << expected.offset;
    printed("centred", {exposePixel(strips, kCentreAnchor, x).colour, mcguire(15), mcguire(31), paired});
  }
  double before_rounding = overJitters([&](double j) {
    return mcguireAt(row, dominant[160], 160, {.samples = 31, .jitter = j, .rounded_distance = false});
  });
  EXPECT_NEAR(before_rounding, .6889, kFourDigits);
  printed("before_rounding", {before_rounding});
}

TEST(Gather, McGuireJustInsideAnEdgeTendsToSixSevenths) {
  // A path of 4000 px and as many taps as make the centre tap and the pixel grid negligible.
  Strips strips{{0, 20000, 4000, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  Row row = rasterise(strips, 24000);
  EXPECT_NEAR(mcguireAt(row, 4000, 19999, {.samples = 3001}), 6.0 / 7, 2e-3);
}

TEST(Gather, GuertinOnTheWhiteBar) {
  struct {
    int offset;
    double one, two;
  } constexpr kTable[] = {{-10, 1, 1},       {-6, .9797, .9797}, {-4, .9526, .9526}, {-1, .8717, .8717},
                          {0, .8265, .7011}, {2, .7479, .5684},  {5, .5092, .3687},  {8, .0929, .0929}};
  Row row = rasterise(whiteBar(), 320);
  for (auto [offset, one, two] : kTable)
    for (bool both : {false, true}) {
      double value =
          overJitters([&, at = 160 + offset](double j) { return guertinAt(row, 20, at, {.jitter = j, .two = both}); });
      EXPECT_NEAR(value, both ? two : one, kFourDigits) << offset;
      printed(both ? "guertin_two" : "guertin_one", {value});
    }
}

// The weights of Guertin et al. 2014 before directions, with the edits their code made to McGuire's filter.
TEST(Gather, McGuireWithTheCentreWeightAndCylinderOfItsSuccessor) {
  const std::pair<int, double> table[] = {{-10, 1.0000}, {-6, .9775}, {-4, .9458}, {-1, .8572},
                                          {0, .8228},    {2, .7469},  {5, .5087},  {8, .0827}};
  Row row = rasterise(whiteBar(), 320);
  Guertin edited{.samples = 15, .two = false, .eta = 1, .hard_cylinder = true, .rounded_distance = true};
  for (const auto& [offset, expected] : table) {
    double value = overJitters([&, at = 160 + offset](double j) {
      edited.jitter = j;
      return guertinAt(row, 20, at, edited);
    });
    EXPECT_NEAR(value, expected, kFourDigits) << offset;
    printed("edited", {value});
  }
}

// Just outside the edge a quarter of the samples have a mean weight of 1, and the pixel itself, which spreads over 1/2
// px, has the weight N / 20. The foreground's share is 5/6 for every N; in McGuire's filter it is (N/4) / (N/4 + 2).
TEST(Gather, GuertinsOpacityDoesNotDependOnTheNumberOfSamples) {
  Strips strips{{0, 20000, 4000, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  Row row = rasterise(strips, 24000);
  for (int samples : {64, 256, 1024}) {
    EXPECT_NEAR(guertinAt(row, 4000, 20000, {.samples = samples, .two = false}), 5.0 / 6, 8e-3) << samples;
    // The static pixel leaves out the samples across the motion; half of the foreground's samples remain.
    EXPECT_NEAR(guertinAt(row, 4000, 20000, {.samples = samples}), 5.0 / 7, 8e-3) << samples;
  }
}

// Over a constant background the weights of Jimenez' filter are exact coverage.
TEST(Gather, RampsOverAConstantBackgroundAreExactCoverage) {
  Strips strips = whiteBar();
  Row row = rasterise(strips, 320);
  for (Window window : {kCloseAnchor, kCentreAnchor, kOpenAnchor})
    for (int x = 60; x < 200; ++x) {
      double value =
          overJitters([&](double j) { return pairedAt(row, 20, x, {.samples = 16, .jitter = j, .window = window}); });
      EXPECT_NEAR(value, exposePixel(strips, window, x).colour, 1e-3) << x << " from " << window.open;
    }
}

TEST(Gather, OneSidedMcGuireOnTheWhiteBar) {
  struct {
    int x;
    double truth, mcguire;
  } constexpr kTable[] = {{145, .725, .984}, {150, .475, .919}, {155, .225, .707}, {159, .025, .007},
                          {81, .275, .229},  {86, .525, .523},  {91, .775, .706},  {95, .975, .789}};
  Strips strips = whiteBar();
  Row row = rasterise(strips, 320);
  auto dominant = dominantDisplacement({&row}, 20, kCloseAnchor);
  for (auto [x, truth, expected] : kTable) {
    double mcguire =
        overJitters([&, x = x](double j) { return mcguireAt(row, dominant[x], x, {.jitter = j, .one_sided = true}); });
    EXPECT_NEAR(exposePixel(strips, kCloseAnchor, x).colour, truth, 1e-9) << x;
    EXPECT_NEAR(mcguire, expected, kThreeDigits) << x;
    printed("one_sided", {exposePixel(strips, kCloseAnchor, x).colour, mcguire});
  }
}

// A grey surface with its leading edge at 288, 40 px over the exposure, over white that ends 8 px beyond the edge.
struct HiddenWhite {
  static constexpr int kEdge = 288;
  Strips strips{{160, kEdge, 40, {0.5}}, {-kInfinity, kEdge + 8, 0, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  Row row = rasterise(strips, 480);

  double gathered(int x, bool mirror) const {
    return overJitters([&](double j) { return pairedAt(row, 40, x, {.samples = 32, .jitter = j, .mirror = mirror}); });
  }
};

TEST(Gather, PairsTakeTheBackgroundFromBeyondTheEdge) {
  struct {
    int depth_px;
    double background;
  } constexpr kTable[] = {{0, .4099}, {5, .5512}, {10, .8413}, {12, 1.0000}};
  HiddenWhite scene;
  for (auto [s, expected] : kTable) {
    double alpha = 0.5 + (s + 0.5) / 40;
    double background = (scene.gathered(HiddenWhite::kEdge - 1 - s, true) - alpha * 0.5) / (1 - alpha);
    EXPECT_NEAR(background, expected, kFourDigits) << s;
    // Mean from the edge to the end of the taps; the true background is white throughout.
    EXPECT_NEAR(background, std::min(1.0, 8 / (20 - (s + 0.5))), 1.5e-3) << s;
    printed("invented", {background, std::min(1.0, 8 / (20 - (s + 0.5)))});
  }
}

TEST(Gather, MirrorPutsTheOppositeSideUnderTheOuterBlur) {
  HiddenWhite scene;
  int x = HiddenWhite::kEdge;
  EXPECT_NEAR(scene.gathered(x, true), .4438, kFourDigits);
  EXPECT_NEAR(scene.gathered(x, false), .7563, kFourDigits);
  EXPECT_NEAR(exposePixel(scene.strips, kCentreAnchor, x).colour, .75625, 1e-9);
  printed("mirror",
          {exposePixel(scene.strips, kCentreAnchor, x).colour, scene.gathered(x, false), scene.gathered(x, true)});
}

TEST(Gather, MirrorChangesNothingInside) {
  HiddenWhite scene;
  for (int s = 0; s < 20; ++s)
    EXPECT_NEAR(scene.gathered(HiddenWhite::kEdge - 1 - s, true), scene.gathered(HiddenWhite::kEdge - 1 - s, false),
                1e-12);
}

// --- Layers ---

StripedBar gentle(double d_front, double d_back) { return {.d_front = d_front, .d_back = d_back}; }

StripedBar harsh(double d_front, double d_back) {
  return {100, {0.8, 0.2, 6, 100}, {0.9, 0.1, 10, 0}, d_front, d_back};
}

struct LayeredCase {
  double d_front, d_back;
  double own_rms, own_max, relative_rms, relative_max;
};

constexpr LayeredCase kHarshTable[] = {
    {20, 0, .0076, .020, .0076, .020},  {20, 6, .0093, .029, .0093, .029},   {20, 12, .0114, .033, .0114, .033},
    {20, 20, .0069, .016, .0069, .016}, {20, -12, .0435, .274, .0094, .021}, {12, -12, .0515, .314, .0058, .015},
    {0, 20, .1019, .400, .0000, .000},  {6, 20, .0861, .400, .0046, .013},   {11, -12, .0505, .293, .0084, .018},
    {6, -20, .0750, .325, .0036, .011},
};
constexpr LayeredCase kGentleTable[] = {
    {20, 0, .0032, .012, .0032, .012},  {20, 6, .0039, .020, .0039, .020},   {20, 12, .0050, .017, .0050, .017},
    {20, 20, .0040, .012, .0040, .012}, {20, -12, .0148, .098, .0042, .012}, {12, -12, .0191, .101, .0042, .011},
    {0, 20, .0321, .172, .0025, .006},  {6, 20, .0244, .128, .0036, .016},   {11, -12, .0213, .129, .0044, .014},
    {6, -20, .0198, .120, .0032, .010},
};

void expectCase(const StripedBar& bar, const LayeredCase& c, const std::string& name) {
  SCOPED_TRACE(::testing::Message() << "foreground " << c.d_front << " px, background " << c.d_back << " px");
  Layered options{.samples = 32, .both_ways = true};
  RowError own = layeredError(bar, Mask::kOwn, options, kCloseAnchor);
  RowError relative = layeredError(bar, Mask::kRelative, options, kCloseAnchor);
  EXPECT_NEAR(own.rms, c.own_rms, kFourDigits);
  EXPECT_NEAR(own.max, c.own_max, kThreeDigits);
  EXPECT_NEAR(relative.rms, c.relative_rms, kFourDigits);
  EXPECT_NEAR(relative.max, c.relative_max, kThreeDigits);
  EXPECT_EQ(relative.fallbacks, 0);
  printed(name, {own.rms, own.max, relative.rms, relative.max});
}

TEST(LayeredGather, HarshStripes) {
  for (const LayeredCase& c : kHarshTable) expectCase(harsh(c.d_front, c.d_back), c, "harsh");
}

TEST(LayeredGather, GentleStripes) {
  for (const LayeredCase& c : kGentleTable) expectCase(gentle(c.d_front, c.d_back), c, "gentle");
}

TEST(LayeredGather, RelativeMaskLeavesOnlySamplingError) {
  for (const LayeredCase& c : kGentleTable)
    for (Window window : {kCloseAnchor, kCentreAnchor, kOpenAnchor})
      for (double left : {120.0, 125.0, 131.0}) {
        StripedBar bar = gentle(c.d_front, c.d_back);
        bar.left = left;
        RowError error = layeredError(bar, Mask::kRelative, {.samples = 32, .both_ways = true}, window);
        EXPECT_LE(error.rms, 0.0065) << c.d_front << " " << c.d_back << " " << left;
        EXPECT_LE(error.max, 0.03) << c.d_front << " " << c.d_back << " " << left;
        EXPECT_EQ(error.fallbacks, 0);
      }
}

TEST(LayeredGather, WithoutSearchTapsTheSlowerSurfaceIsMissed) {
  Layered options{.samples = 32, .harvest = false};
  RowError following = layeredError(harsh(20, 12), Mask::kRelative, options, kCloseAnchor);
  EXPECT_NEAR(following.rms, .0472, kFourDigits);
  EXPECT_NEAR(following.max, .391, kThreeDigits);
  RowError tracking = layeredError(harsh(6, 20), Mask::kRelative, options, kCloseAnchor);
  EXPECT_NEAR(tracking.rms, .0440, kFourDigits);
  EXPECT_NEAR(tracking.max, .291, kThreeDigits);
  printed("no_harvest", {following.rms, following.max, tracking.rms, tracking.max});
}

TEST(LayeredGather, OneWaySearchTapsMissASlowerOpposedSurface) {
  Layered one_way{.samples = 32};
  for (auto [d_front, d_back] : {std::pair{11.0, -12.0}, {6.0, -20.0}, {12.0, -12.0}}) {
    RowError error = layeredError(gentle(d_front, d_back), Mask::kRelative, one_way, kCloseAnchor);
    EXPECT_GT(error.rms, 0.07) << d_front << " " << d_back;
    EXPECT_EQ(error.fallbacks, 0);  // no fallback: the background is found where the bar should be
    printed("one_way", {error.rms, error.max});
  }
}

TEST(LayeredGather, AlphaOverOfPerfectLayersIsExactOnlyOverAStaticBackground) {
  auto error = [](const StripedBar& bar) {
    RowError result;
    Strips strips = bar.strips();
    int first = static_cast<int>(bar.left) - 45, count = 64 + 90;
    for (int x = first; x < first + count; ++x) {
      double e = alphaOverAt(strips, kCloseAnchor, x) - exposeCentre(strips, kCloseAnchor, x).colour;
      result.rms += e * e / count;
      result.max = std::max(result.max, std::abs(e));
    }
    result.rms = std::sqrt(result.rms);
    return result;
  };
  EXPECT_LE(error(harsh(20, 0)).max, 1e-12);
  EXPECT_LE(error(harsh(0, 20)).max, 1e-12);  // the foreground covers a pixel always or never
  EXPECT_NEAR(error(harsh(20, 12)).rms, .0470, kFourDigits);
  EXPECT_NEAR(error(harsh(20, 12)).max, .193, kThreeDigits);
  printed("perfect_layers", {error(harsh(20, 12)).max});
  EXPECT_NEAR(error(harsh(20, 20)).rms, .0470, kFourDigits);
  EXPECT_NEAR(error(harsh(6, 20)).rms, .0252, kFourDigits);
}

TEST(LayeredGather, ErrorIsWithinTheBoundOfItsSamples) {
  // With both layers known, only time sampling and rounding to the nearest pixel remain: up to 3/4 px of each crossing.
  for (const LayeredCase& c : kHarshTable) {
    StripedBar bar = harsh(c.d_front, c.d_back);
    Strips strips = bar.strips();
    Row raster = rasterise(strips, 320);
    Row revealed = reveal(strips, raster, hiddenMask(raster, Mask::kRelative, kCloseAnchor));
    auto colour = gatherLayered(raster, revealed, {.samples = 32, .both_ways = true}, kCloseAnchor).colour;
    double slowest = std::min(std::abs(c.d_front), std::abs(c.d_back));
    if (slowest == 0) slowest = std::max(std::abs(c.d_front), std::abs(c.d_back));
    for (int x = 55; x < 209; ++x) {
      Exposure exact = exposeCentre(strips, kCloseAnchor, x);
      ASSERT_NEAR(colour[x], exact.colour, exact.variation * (1.0 / 64 + 0.75 / slowest) + 1e-9) << x;
    }
  }
}

TEST(HiddenMask, MarksTheLeadingBandOfABar) {
  Row row = rasterise(whiteBar(), 320);
  for (Mask mask : {Mask::kOwn, Mask::kRelative}) {
    auto close = hiddenMask(row, mask, kCloseAnchor);
    auto open = hiddenMask(row, mask, kOpenAnchor);
    for (int x = 0; x < 320; ++x) {
      EXPECT_EQ(close[x], x >= 140 && x < 160) << x;
      EXPECT_EQ(open[x], x >= 96 && x < 116) << x;
    }
  }
}

TEST(HiddenMask, TrackingShotNeedsRelativeMotion) {
  Row row = rasterise(gentle(0, 20).strips(), 320);
  auto own = hiddenMask(row, Mask::kOwn, kCloseAnchor);
  auto relative = hiddenMask(row, Mask::kRelative, kCloseAnchor);
  for (int x = 0; x < 320; ++x) {
    EXPECT_FALSE(own[x]);
    EXPECT_EQ(relative[x], x >= 128 && x < 148) << x;
  }
}

}  // namespace gather_1d_test
}  // namespace strobe::oracle
