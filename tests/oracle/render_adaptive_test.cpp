// SPDX-License-Identifier: MIT
// The parameter `quality` of the pipeline `adaptive`: 0 is a post-process blur and 1 is truth, bit for bit. Between
// them, more quality traces more rays and has less error, and regions of equal motion are gathered only. Against closed
// forms, truth and other pipelines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_adaptive_test {

constexpr int kWidth = 96, kHeight = 54;

class RenderAdaptive : public RenderTest {
 protected:
  static lab::Shot shot(const std::string& scene) {
    return scene == "crowd" ? shotOf("crowd", kWidth, kHeight)
                            : shotOf("../objects/" + scene, kWidth, kHeight, {{"pixels", 14}});
  }
  static lab::Picture at(const lab::Shot& shot, double quality, std::vector<std::string> more = {},
                         const std::string& anchor = "") {
    more.push_back(fmt::format("quality={}", quality));
    return render(with(shot, "adaptive", more, anchor));
  }
  // Truth of 512 samples, rendered once per scene.
  static const image::Image& truthOf(const std::string& scene) {
    static std::map<std::string, image::Image> truths;
    auto [found, added] = truths.try_emplace(scene);
    if (added)
      found->second = colorOf(render(with(shot(scene), "ground_truth", {"samples=512", "mark_regions=false"})));
    return found->second;
  }
  // Number of rays of all passes.
  static uint64_t raysOf(const lab::Picture& picture) {
    uint64_t rays = 0;
    for (const auto& [name, count] : picture.frame.counters)
      if (name.find(".rays_") != std::string::npos) rays += count;
    return rays;
  }
};

TEST_F(RenderAdaptive, QualityZeroIsThePostProcess) {
  for (const Anchor& anchor : anchors())
    for (const char* scene : {"crowd", "stacked"}) {
      SCOPED_TRACE(fmt::format("{} {}", scene, anchor.name));
      const lab::Picture own = at(shot(scene), 0, {}, anchor.name);
      const lab::Picture gather = render(with(shot(scene), "ue4", {}, anchor.name));
      EXPECT_TRUE(identical(colorOf(own), colorOf(gather)));
      EXPECT_EQ(raysOf(own), raysOf(gather));
    }
}

TEST_F(RenderAdaptive, QualityOneIsTruth) {
  for (const char* scene : {"stacked", "tracking_parallax"}) {
    SCOPED_TRACE(scene);
    const lab::Picture own = at(shot(scene), 1, {"samples=8"});
    EXPECT_TRUE(identical(colorOf(own),
                          colorOf(render(with(shot(scene), "ground_truth", {"samples=128", "mark_regions=false"})))));
    // The bound is the standard error of other samples, plus the error of midpoints, which is no larger.
    const lab::Picture truth = render(with(shot(scene), "ground_truth", {"samples=128", "times=stratified"}));
    EXPECT_LE(rmsDifference(colorOf(own), colorOf(truth)), 2 * rms(imageOf(truth, "error")));
  }
}

TEST_F(RenderAdaptive, MoreQualityTracesMoreAndHasLessError) {
  for (const char* scene : {"stacked", "tracking_parallax", "caged_fan"}) {
    double last = INFINITY;
    uint64_t rays = 0;
    for (double quality : {0., .1, .3, .5, .7, .9}) {
      SCOPED_TRACE(fmt::format("{} {}", scene, quality));
      const lab::Picture own = at(shot(scene), quality);
      const double error = rmsDifference(colorOf(own), truthOf(scene));
      EXPECT_LT(error, last);
      EXPECT_GT(raysOf(own), rays);
      last = error, rays = raysOf(own);
    }
  }
}

// A bar and a background of equal motion. Away from the picture's border each pixel is gathered: it is the mean of the
// texels that pass over it.
TEST_F(RenderAdaptive, RegionsOfEqualMotionAreGathered) {
  constexpr int kSamples = 8, kBorder = 30;
  const lab::Shot alike = shotOf("textured_bar", 128, 40, {{"d_f", 16}, {"d_b", 16}});
  const lab::Picture own = at(alike, .4, {"samples=8"}, "end");
  const image::Image sharp = colorOf(render(with(alike, "none", {}, "end")));
  const image::Image& color = colorOf(own);
  const image::Image& error = imageOf(own, "error");
  double worst = 0, worst_error = 0;
  for (int y = 10; y < 30; ++y)
    for (int x = kBorder; x < 128 - kBorder; ++x) {
      double sum = 0, variance = 0, last = 0;
      for (int i = 0; i < kSamples; ++i) {
        const double tap = sharp.at(x + int(std::floor(16 * (1 - (i + .5) / kSamples) + .5)), y, 0);
        // The colour changes between two taps at a time that is distributed uniformly over the interval.
        if (i > 0) variance += (tap - last) * (tap - last) / (12 * kSamples * kSamples);
        sum += tap, last = tap;
      }
      worst = std::max(worst, std::abs(color.at(x, y, 0) - sum / kSamples));
      worst_error = std::max(worst_error, std::abs(error.at(x, y, 0) - std::sqrt(variance)));
    }
  EXPECT_LE(worst, 1e-6);
  EXPECT_LE(worst_error, 1e-6);
  EXPECT_GE(counterOf(own, "adaptive_times.gathered"), 128u * 40 / 3);
}

// Rays find a bar that is in the picture only before the raster time, a bar that is half inside, and a bar that enters
// from outside. The bound is the shortest interval between two rays.
TEST_F(RenderAdaptive, RaysFindSurfacesOutsideTheRasterImage) {
  struct Bar {
    double left, right, d;
  };
  for (const Bar& bar : {Bar{70.3, 90.3, 40}, Bar{50.3, 80.3, 30}, Bar{12.3, 28.3, 40}}) {
    SCOPED_TRACE(bar.left);
    const lab::Shot moving = shotOf("bar", 64, 12, {{"left", bar.left}, {"right", bar.right}, {"d_f", bar.d}});
    const Strips exact = {{bar.left, bar.right, bar.d, {1}}, {-kInfinity, kInfinity, 0, {0}}};
    const lab::Picture own = at(moving, .7, {}, "end");
    for (int x = 0; x < 64; ++x)
      EXPECT_NEAR(colorOf(own).at(x, 6, 0), exposeCentre(exact, kCloseAnchor, x).colour, 1. / 32 + 1e-4) << x;
  }
}

// A panel narrower than the distance it moves between two of the first rays. It passes over pixels whose rays hit only
// the background before and after the panel. Each pixel has the exact coverage to within the shortest interval between
// two rays, a sixteenth of the exposure at these qualities.
TEST_F(RenderAdaptive, APanelBetweenTwoAgreeingRaysIsFound) {
  constexpr double kLeft = 60.3, kPanel = 8, kMoved = 64;
  const lab::Shot passes = shotOf("bar", 192, 12, {{"left", kLeft}, {"right", kLeft + kPanel}, {"d_f", kMoved}});
  const Strips exact = {{kLeft, kLeft + kPanel, kMoved, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  for (const Anchor& anchor : anchors())
    for (double quality : {.1, .3, .5}) {
      SCOPED_TRACE(fmt::format("{}, quality {}", anchor.name, quality));
      const image::Image color = colorOf(at(passes, quality, {}, anchor.name));
      for (int x = 0; x < 192; ++x)
        EXPECT_NEAR(color.at(x, 6, 0), exposeCentre(exact, anchor.window, x).colour, 1. / 16 + 1e-4) << x;
    }
}

// A bar with one stripe in the colour of the background and a dark stripe. A pixel between two rays that hit the first
// stripe and the background still shows the dark stripe: each pixel is exact to within the shortest interval.
TEST_F(RenderAdaptive, AStripeBetweenTwoAgreeingSurfacesIsFound) {
  constexpr double kLeft = 120, kStripe = 12, kMoved = 64, kLight = .9, kDark = .1;
  const lab::Shot passes = shotOf("textured_bar", 384, 12,
                                  {{"left", kLeft},
                                   {"right", kLeft + 2 * kStripe},
                                   {"d_f", kMoved},
                                   {"period_f", kStripe},
                                   {"f_light", kLight},
                                   {"f_dark", kDark},
                                   {"b_light", kLight},
                                   {"b_dark", kLight}});
  const Strips exact = {{kLeft, kLeft + 2 * kStripe, kMoved, {kLight, kDark, kStripe, kLeft}},
                        {-kInfinity, kInfinity, 0, {kLight}}};
  for (const Anchor& anchor : anchors())
    for (double quality : {.1, .3, .5}) {
      SCOPED_TRACE(fmt::format("{}, quality {}", anchor.name, quality));
      const image::Image color = colorOf(at(passes, quality, {}, anchor.name));
      for (int x = 0; x < 384; ++x)
        EXPECT_NEAR(color.at(x, 6, 0), exposeCentre(exact, anchor.window, x).colour, (kLight - kDark) / 16 + 1e-4) << x;
    }
}

// A hit takes its colour from the surrounding raster texels only if these texels differ little. The texels of fine
// stripes differ by the contrast of the stripes, so hits on strong stripes are shaded, and hits on weak stripes are
// blended.
TEST_F(RenderAdaptive, HitsBetweenTexelsThatDifferAreShaded) {
  auto shareShaded = [](double light, double dark) {
    const lab::Shot stripes =
        shotOf("textured_bar", 128, 12,
               {{"left", 40}, {"right", 88}, {"d_f", 20.5}, {"period_f", 1}, {"f_light", light}, {"f_dark", dark}});
    const lab::Picture own = at(stripes, .4);
    return double(counterOf(own, "adaptive_times.shaded")) / double(counterOf(own, "adaptive_times.samples"));
  };
  EXPECT_GT(shareShaded(.9, .1), .4);
  EXPECT_LT(shareShaded(.501, .499), .1);
}

// A bar outside the raster image passes over static cells: the cells' validation rays hit it.
TEST_F(RenderAdaptive, ValidationRaysFindMismatchedCells) {
  const lab::Picture own = at(shotOf("bar", 64, 40, {{"left", 70.3}, {"right", 90.3}, {"d_f", 40}}), .4, {}, "end");
  EXPECT_GT(counterOf(own, "coherent_cells.checked"), counterOf(own, "coherent_cells.mismatched"));
  EXPECT_GT(counterOf(own, "coherent_cells.mismatched"), 0u);
}

// Pixels of a certain cell are gathered, or static, unless a ray has found a mismatch in one of the nine cells around
// them.
TEST_F(RenderAdaptive, CellsBesideAMismatchedCellAreTraced) {
  constexpr int kWide = 128, kHigh = 40, kSide = 10;
  lab::Shot enters = shotOf("textured_bar", kWide, kHigh, {{"left", 134}, {"right", 154}, {"d_f", 40}, {"d_b", 8}});
  enters.taps = {"coherent_cells.certain"};
  const lab::Picture own = at(enters, .4, {fmt::format("tile={}", kSide)}, "end");
  const image::Image& certain = own.frame.taps.at("coherent_cells.certain").floats;
  auto isRefuted = [&](int x, int y) { return std::abs(certain.at(x, y, 0) - .25) < .1; };
  size_t gathered = 0, beside = 0;
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      const int cell_x = x / kSide, cell_y = y / kSide;
      if (certain.at(cell_x, cell_y, 0) < .4) continue;
      bool refuted = false;
      for (int k = 0; k < 9; ++k)
        refuted |= isRefuted(std::clamp(cell_x + k % 3 - 1, 0, int(certain.width) - 1),
                             std::clamp(cell_y + k / 3 - 1, 0, int(certain.height) - 1));
      ++(refuted ? beside : gathered);
    }
  EXPECT_EQ(counterOf(own, "adaptive_times.gathered"), gathered);
  EXPECT_GT(beside, 0u);
}

// The left edge of a static card lies a thousandth of a pixel right of a pixel's centre. Rasterisation snaps the edge
// to the centre and draws the card there; rays miss the card. The pixel shows only the moving background, at all times.
TEST_F(RenderAdaptive, StaticCardsBeginAtTheirRayHits) {
  constexpr float kCard = .5, kBehind = .75;
  for (const Anchor& anchor : anchors()) {
    const lab::Shot shot = shotOf("cards", 96, 8,
                                  {{"left0", 30.501},
                                   {"right0", 60},
                                   {"v0", kCard},
                                   {"left1", -80},
                                   {"right1", 170},
                                   {"z1", -5},
                                   {"v1", kBehind},
                                   {"d1", anchor.name == "end" ? -6 : 6}});
    const image::Image sharp = colorOf(render(with(shot, "none"))), color = colorOf(at(shot, .4, {}, anchor.name));
    for (int y = 0; y < color.height; ++y) {
      EXPECT_FLOAT_EQ(sharp.at(30, y, 0), kCard) << anchor.name << ' ' << y;
      EXPECT_FLOAT_EQ(color.at(30, y, 0), kBehind) << anchor.name << ' ' << y;
      EXPECT_FLOAT_EQ(color.at(31, y, 0), kCard) << anchor.name << ' ' << y;
    }
  }
}

// A gather inside a surface of one colour would move the static texture beside the surface along with it. The raster
// image and the truth have equal resolution, so the only error is from the intervals between rays.
TEST_F(RenderAdaptive, AGatherDoesNotMoveAStaticBackground) {
  for (const lab::Shot& shot :
       {shotOf("../behind", kWidth, kHeight),
        shotOf("quad_2d", kWidth, kHeight, {{"left", 30}, {"right", 60}, {"top", 12}, {"bottom", 42}})}) {
    SCOPED_TRACE(shot.scene);
    const image::Image truth = colorOf(render(with(shot, "ground_truth", {"samples=256", "mark_regions=false"})));
    const double gather = rmsDifference(colorOf(render(with(shot, "ue4"))), truth);
    EXPECT_LE(rmsDifference(colorOf(at(shot, .5)), truth), 0.05 * gather);
  }
}

// A card slides in and back, so its displacement over the exposure is 0. Rays hit the card, but not at the point that
// the displacement predicts.
TEST_F(RenderAdaptive, ValidationRaysFindMotionWithoutDisplacement) {
  lab::Shot shot = shotOf("../turns_back", kWidth, kHeight);
  shot.frame = 1;
  const lab::Picture own = at(shot, .5, {}, "centre");
  EXPECT_GT(counterOf(own, "coherent_cells.mismatched"), 0u);
  const image::Image truth =
      colorOf(render(with(shot, "ground_truth", {"samples=256", "mark_regions=false"}, "centre")));
  EXPECT_LE(rmsDifference(colorOf(own), truth),
            0.4 * rmsDifference(colorOf(render(with(shot, "ue4", {}, "centre"))), truth));
}

// The estimate is a standard deviation: over a picture, its mean is within a factor of 2 of the mean error (measured:
// 0.6 to 1.6). Static pixels have no error.
TEST_F(RenderAdaptive, EstimatesItsError) {
  for (const char* scene : {"stacked", "tracking_parallax", "crowd"}) {
    SCOPED_TRACE(scene);
    const lab::Picture own = at(shot(scene), .4);
    const image::Image& truth = truthOf(scene);
    const image::Image error = imageOf(own, "error"), color = colorOf(own);
    double estimated = 0, actual = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        double squares = 0;
        for (int c = 0; c < 3; ++c) squares += std::pow(color.at(x, y, c) - truth.at(x, y, c), 2);
        estimated += error.at(x, y, 0), actual += std::sqrt(squares / 3);
      }
    EXPECT_LT(estimated, 2 * actual);
    EXPECT_GT(estimated, actual / 2);
  }
  const lab::Picture rests = render(with(shot("stacked"), "adaptive", {"quality=.4", "scene.pixels=0"}));
  EXPECT_EQ(rms(imageOf(rests, "error")), 0);
}

// The picture's border cuts off the last cells, and the moving surface ends there too: no ray leaves the picture.
// Surfaces from outside the picture enter through the cells of one border only.
TEST_F(RenderAdaptive, ValidationRaysStayInsideThePicture) {
  constexpr int kHigh = 34;
  const lab::Shot moves = shotOf(
      "crossing", 64, kHigh, {{"a_left", -200}, {"a_width", 400}, {"a_top", -8}, {"a_height", 8 + kHigh}, {"a_x", 12}});
  for (const Anchor& anchor : anchors()) {
    const lab::Picture own = at(moves, .4, {}, anchor.name);
    constexpr uint64_t rows = (kHigh + 9) / 10, columns = 2;  // of cells within 12 px of the border
    EXPECT_GT(counterOf(own, "coherent_cells.checked"), columns * rows) << anchor.name;
    EXPECT_LE(counterOf(own, "coherent_cells.mismatched"), columns * rows) << anchor.name;
  }
}

}  // namespace render_adaptive_test
}  // namespace strobe::oracle
