// SPDX-License-Identifier: MIT
// Layers revealed by rays, against scenes whose layers are known in closed form.
#include <fmt/format.h>

#include <cmath>

#include "common/source.h"
#include "math/constants.h"
#include "oracle/gather_1d.h"
#include "oracle/printed.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_reveal_test {

constexpr int kWidth = 16, kHeight = 8;
const std::string kPipelines = sourceFolder().string() + "/tests/oracle/pipelines/";
const std::string kHits = sourceFolder().string() + "/scripts/inspect/hits.lua";

// Parameters of tests/oracle/scenes/layers.lua.
struct Planes {
  double scale = 1, gap = 1e-3, slope = 0;
  int split = 0, count = 4;
  std::vector<double> values = {.5, .5, .5, .5};

  lab::Shot shot() const {
    Numbers numbers = {{"scale", scale}, {"gap", gap}, {"slope", slope}, {"split", split}, {"count", count}};
    for (size_t k = 0; k < values.size(); ++k) numbers.push_back({fmt::format("v{}", k), values[k]});
    return shotOf("layers", kWidth, kHeight, numbers);
  }
  // The ray through column x gains tangent(x) to the right per unit of depth: z = z_k + slope * z * tangent.
  double depthOf(double on_axis, int x) const {
    double tangent = (x + .5 - kWidth / 2.) / (kHeight / 2.);
    return on_axis / (1 - slope * tangent);
  }
  double depth(int plane, int x) const { return depthOf(10 * scale * (1 + plane * gap), x); }
  double wall(int x) const { return depthOf(20 * scale, x); }
};

// Single precision gives a depth to a few parts in 10^7, far less than the distance between the planes.
void expectDepth(const image::Image& depths, const std::function<double(int x)>& expected, double tolerance,
                 const std::string& what) {
  double worst = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) worst = std::max(worst, std::abs(depths.at(x, y, 0) / expected(x) - 1));
  EXPECT_LE(worst, tolerance) << what << ": " << depths.at(0, 0, 0) << " for " << expected(0);
}

// Index of the plane whose depth on the axis is nearest to the depth of the pixel beside the axis; -1 for the wall.
int planeSeen(const Planes& planes, const image::Image& depths) {
  double depth = depths.at(kWidth / 2, kHeight / 2, 0);
  for (int k = 0; k < planes.count; ++k)
    if (std::abs(depth / planes.depth(k, kWidth / 2) - 1) < planes.gap / 4) return k;
  return -1;
}

// The luminance rule of termination, in double precision.
bool endsBy(double front, double here, double tolerance) {
  return std::abs(here - front) > tolerance * std::max(here, front) + 1e-4;
}
double expectedByLuminance(const std::vector<double>& values, double tolerance) {
  for (double value : values)
    if (endsBy(values[0], value, tolerance)) return value;
  return 1;  // the wall
}

const image::UintImage& uintsOf(const lab::Picture& picture, const std::string& output) {
  return picture.frame.outputs.at(output).uints;
}

std::string raysOf(const lab::Picture& picture, const std::string& node) {
  return fmt::format("{}.rays_{}", node, picture.record["device"]["backend"].get<std::string>());
}

class RenderReveal : public RenderTest {
 protected:
  lab::Picture advances(const Planes& planes) { return render(with(planes.shot(), kPipelines + "advances.lua")); }
};

// Layer by layer, on planes oblique to every ray, over nine orders of magnitude.
TEST_F(RenderReveal, WaysOfAdvancingAgreeLayerByLayer) {
  for (double scale : {1., 1e-3, 1e3, 1e6}) {
    Planes planes{.scale = scale, .slope = .3, .count = 5};
    lab::Picture picture = advances(planes);
    for (const char* advance : {"origin_kept", "restart"}) {
      std::string what = fmt::format("{} at scale {}", advance, scale);
      for (int most = 1; most <= 4; ++most)
        expectDepth(
            imageOf(picture, fmt::format("{}_{}", advance, most)), [&](int x) { return planes.depth(most, x); }, 1e-5,
            fmt::format("{} layer {}", what, most));
      expectDepth(
          imageOf(picture, fmt::format("{}_all", advance)), [&](int x) { return planes.wall(x); }, 1e-5, what);
    }
    for (const char* cap : {"1", "4", "few", "all"})
      expectDepth(
          imageOf(picture, fmt::format("instance_filter_{}", cap)), [&](int x) { return planes.wall(x); }, 1e-5,
          fmt::format("instance_filter at scale {}", scale));
  }
}

// Planes 4e-6 of their depth apart. A restarted ray begins 1e-5 of the depth later, beyond two planes.
TEST_F(RenderReveal, OnlyAKeptOriginFindsCloseLayers) {
  for (double scale : {1., 1e6}) {
    Planes planes{.scale = scale, .gap = 4e-6, .count = 9};
    lab::Picture picture = advances(planes);
    EXPECT_EQ(planeSeen(planes, imageOf(picture, "origin_kept_1")), 1) << scale;
    EXPECT_EQ(planeSeen(planes, imageOf(picture, "origin_kept_4")), 4) << scale;
    EXPECT_EQ(planeSeen(planes, imageOf(picture, "restart_1")), 3) << scale;
    expectDepth(
        imageOf(picture, "instance_filter_1"), [&](int x) { return planes.wall(x); }, 1e-5, "instance_filter");
  }
}

// Two instances in one place count as one surface, with every way of advancing.
TEST_F(RenderReveal, SurfacesInOnePlaceCountAsOne) {
  Planes planes{.gap = 0, .split = 1, .count = 2};
  lab::Picture picture = advances(planes);
  for (const char* advance : {"origin_kept", "restart", "instance_filter"})
    expectDepth(
        imageOf(picture, fmt::format("{}_1", advance)), [&](int x) { return planes.wall(x); }, 1e-5, advance);
}

// At frame 2 of a camera that slides along x by 0.5 m per frame, a surface moves left by the camera's motion over the
// exposure, times 4 px of focal length over the depth.
TEST_F(RenderReveal, CameraPathsCauseDisplacements) {
  lab::Shot shot = with(Planes{.count = 1}.shot(), "none");
  shot.path = {"0=0,0,0,0,0,-1", "1=0.5,0,0,0.5,0,-1", "4=2,0,0,2,0,-1"};
  shot.frame = 2, shot.exposure = 0.5;
  lab::Picture picture = render(shot);
  EXPECT_NEAR(imageOf(picture, "velocity").at(3, 3, 0), -0.5 * 4 * 0.5 / 10, 1e-6);
  EXPECT_NEAR(picture.camera_from_world[3][0], -1, 1e-6);
}

// Depths are exact on surfaces of any length along any axis: the rounding of the corners is a metre here.
TEST_F(RenderReveal, DepthsOnALongRoadAreExact) {
  constexpr int kSide = 32;
  lab::Shot shot = shotOf("road", kSide, kSide);
  shot.sets.clear();
  const image::Image depth = imageOf(render(with(shot, "none")), "depth");
  const double focal = kSide / 2. / std::tan(kPi / 6);
  int seen = 0;
  for (int y = kSide / 2; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double expected = focal / (y + .5 - kSide / 2.);
      if (expected * std::abs(x + .5 - kSide / 2.) / focal > 1.9) continue;
      ++seen;
      EXPECT_NEAR(depth.at(x, y, 0), expected, 1e-5 * expected) << x << " " << y;
    }
  EXPECT_GT(seen, 100);
}

TEST_F(RenderReveal, CappedRaysAreCounted) {
  lab::Picture picture = advances({.slope = .3, .count = 5});
  const uint64_t all = kWidth * kHeight;
  for (const std::string advance : {"origin_kept", "restart"}) {
    EXPECT_EQ(counterOf(picture, advance + "_few.capped"), all) << advance;
    EXPECT_EQ(counterOf(picture, advance + "_few.revealed"), 0u) << advance;
    EXPECT_EQ(rms(imageOf(picture, advance + "_few")), 0) << advance;  // nothing is revealed
    EXPECT_EQ(counterOf(picture, advance + "_2.capped"), all) << advance;
    EXPECT_EQ(counterOf(picture, advance + "_2.revealed"), all) << advance;
    EXPECT_EQ(counterOf(picture, advance + "_all.capped"), 0u) << advance;
    EXPECT_EQ(counterOf(picture, raysOf(picture, advance + "_2")),
              2 * all + counterOf(picture, advance + "_2.met_again"));
  }
  EXPECT_EQ(counterOf(picture, "instance_filter_few.capped"), 0u);
  EXPECT_EQ(counterOf(picture, raysOf(picture, "instance_filter_few")), all);
}

// Surfaces of equal luminance are passed. The threshold follows its formula for brighter and darker surfaces and in the
// dark.
TEST_F(RenderReveal, LuminanceTerminationFollowsItsFormula) {
  struct Case {
    std::vector<double> values;
    double a, b;
  };
  const Case cases[] = {
      {{.5, .5, .505, .506}, .01, .02},   // the second is equal, the third is within .01, the fourth is not
      {{.5, .52, .6, .7}, .0382, .0384},  // |.52 - .5| is .0382 * .52 + 1.4e-4 and .0384 * .52 + 3e-5
      {{.5, .50005, .5002, .7}, 0, .4},   // constant term 1e-4
      {{0, .00005, .0002, 0}, 0, .01},    // in the dark
      {{.7, .5, .2, .1}, .2, .8},         // darker: the tolerance is a share of the brighter one
  };
  for (const Case& c : cases) {
    Planes planes{.split = 1, .values = c.values};
    lab::Picture picture = render(
        with(planes.shot(), kPipelines + "tolerances.lua", {fmt::format("a={}", c.a), fmt::format("b={}", c.b)}));
    for (const auto& [name, tolerance] : {std::pair("a", c.a), std::pair("b", c.b)})
      EXPECT_NEAR(imageOf(picture, name).at(3, 3, 0), expectedByLuminance(c.values, tolerance), 1e-6)
          << name << " " << tolerance << " of " << fmt::format("{}", fmt::join(c.values, " "));
  }
}

// Planes of tests/oracle/scenes/coats.lua differ first in radiance, then in base colour, then in the mean of the
// material.
TEST_F(RenderReveal, LuminanceUsesTheChosenQuantity) {
  lab::Shot shot = shotOf("coats", kWidth, kHeight);
  lab::Picture picture = render(with(shot, kPipelines + "luminances.lua"));
  const std::pair<const char*, double> depths[] = {{"radiance", 11}, {"base_color", 12}, {"material", 13}};
  for (const auto& [of, depth] : depths)
    expectDepth(
        imageOf(picture, of), [depth = depth](int) { return depth; }, 1e-6, of);
}

// Planes of one instance are its own layers. Planes of other instances that were passed are counted.
TEST_F(RenderReveal, InstancesPassedByLuminanceAreCounted) {
  for (int split : {0, 1}) {
    lab::Shot shot = with(Planes{.split = split}.shot(), hybridSteps(),
                          {"mask=all", "termination=luminance", "advance=origin_kept"});
    EXPECT_EQ(counterOf(render(shot), "ray_reveal.passed"), split ? uint64_t(kWidth * kHeight) : 0u) << split;
  }
}

TEST_F(RenderReveal, InspectorListsTheLayers) {
  Planes planes{.slope = .3, .split = 1, .values = {.1, .2, .3, .4}};
  constexpr int kX = 11, kY = 2;
  lab::Picture listed =
      render(with(planes.shot(), kHits, {fmt::format("pixel_x={}", kX), fmt::format("pixel_y={}", kY)}));
  const image::Image &where = imageOf(listed, "where"), &color = colorOf(listed);
  ASSERT_EQ(color.width, 16);
  ASSERT_EQ(color.height, 1);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(where.at(k, 0, 0) / (k < 4 ? planes.depth(k, kX) : planes.wall(kX)), 1, 1e-6) << k;
    EXPECT_NEAR(color.at(k, 0, 0), k < 4 ? planes.values[size_t(k)] : 1, 1e-6) << k;
    EXPECT_EQ(color.at(k, 0, 3), 1) << k;
    double length = std::hypot(where.at(k, 0, 1), where.at(k, 0, 2), where.at(k, 0, 3));
    EXPECT_NEAR(length, 1, 1e-6) << k;
    EXPECT_NEAR(where.at(k, 0, 1) / where.at(k, 0, 3), .3, 1e-5) << k;  // the plane depth = z + .3 x faces the camera
    EXPECT_EQ(imageOf(listed, "velocity").at(k, 0, 0), 0) << k;
  }
  for (int k = 5; k < 16; ++k) {
    EXPECT_EQ(color.at(k, 0, 3), 0) << k;
    EXPECT_EQ(where.at(k, 0, 0), 0) << k;
  }
}

// The inspector and the pass hit the same surface: at a pixel of the bar, the second hit is the revealed surface.
TEST_F(RenderReveal, InspectorAndPassAgree) {
  lab::Shot shot = shotOf("textured_bar", 96, 4, {{"left", 32}, {"right", 64}, {"d_f", 12}, {"d_b", -7}});
  lab::Picture revealed = render(with(shot, hybridSteps(), {"mask=all", "termination=instance"}));
  for (int x : {33, 47, 60}) {
    lab::Picture listed = render(with(shot, kHits, {fmt::format("pixel_x={}", x), "pixel_y=1"}));
    EXPECT_EQ(imageOf(listed, "where").at(1, 0, 0), imageOf(revealed, "revealed_depth").at(x, 1, 0)) << x;
    EXPECT_EQ(colorOf(listed).at(1, 0, 0), imageOf(revealed, "revealed").at(x, 1, 0)) << x;
    for (int part = 0; part < 2; ++part)  // instance, geometry
      EXPECT_EQ(uintsOf(listed, "hit").at(1, 0, part), uintsOf(revealed, "revealed_id").at(x, 1, part)) << x;
    EXPECT_NE(uintsOf(listed, "hit").at(0, 0, 0), uintsOf(listed, "hit").at(1, 0, 0)) << x;
    EXPECT_EQ(uintsOf(listed, "hit").at(2, 0, 0), 0u) << x;  // nothing is behind the background
    EXPECT_EQ(imageOf(listed, "velocity").at(1, 0, 0), imageOf(revealed, "revealed_velocity").at(x, 1, 0)) << x;
    EXPECT_NEAR(imageOf(listed, "velocity").at(0, 0, 0), 12, 1e-3) << x;
    EXPECT_NEAR(imageOf(listed, "velocity").at(1, 0, 0), -7, 1e-3) << x;
  }
}

// A striped bar of 48 px over stripes.
struct Striped {
  double d_front = 20, d_back = 0;
  static constexpr int kLeft = 48, kRight = 96, kAll = 144;

  lab::Shot shot() const {
    return shotOf("textured_bar", kAll, 4,
                  {{"left", kLeft},
                   {"right", kRight},
                   {"d_f", d_front},
                   {"d_b", d_back},
                   {"period_f", 6},
                   {"period_b", 10},
                   {"f_light", .8},
                   {"f_dark", .2},
                   {"b_light", .9},
                   {"b_dark", .1}});
  }
  Strips strips() const {
    return {{kLeft, kRight, d_front, {.8, .2, 6, kLeft}}, {-kInfinity, kInfinity, d_back, {.9, .1, 10, 0}}};
  }
  // The bar and 20 px to either side: no filter has the surfaces that enter the picture from outside.
  static constexpr int kFirst = kLeft - 20, kLast = kRight + 20;
  RowError error(const lab::Picture& picture) const {
    RowError error;
    for (int x = kFirst; x < kLast; ++x) {
      double e = colorOf(picture).at(x, 1, 0) - exposeCentre(strips(), kCloseAnchor, x).colour;
      error.rms += e * e / (kLast - kFirst);
      error.max = std::max(error.max, std::abs(e));
    }
    error.rms = std::sqrt(error.rms);
    return error;
  }
  lab::Shot hybrid(std::vector<std::string> more) const {
    more.insert(more.end(), {"tile=20", "limit=0.2", "samples=32"});
    return with(shot(), hybridSteps(), more);
  }
};

// A surface whose motion differs from the front surface's by less than 1 px is passed: then only the sky is left.
TEST_F(RenderReveal, MotionTerminationPassesEqualMotion) {
  const std::pair<double, bool> cases[] = {{12, false}, {11.2, false}, {10.8, true}, {-12, true}, {0, true}};
  for (const auto& [d_back, is_other] : cases) {
    Striped scene{12, d_back};
    lab::Picture picture = render(scene.hybrid({"mask=none", "mask.everywhere=true", "termination=motion"}));
    for (int x : {50, 70, 94}) {
      double depth = imageOf(picture, "revealed_depth").at(x, 1, 0);
      EXPECT_EQ(std::isfinite(depth), is_other) << d_back << " " << depth;
      EXPECT_EQ(imageOf(picture, "revealed_valid").at(x, 1, 0), 1) << d_back;
    }
    EXPECT_EQ(counterOf(picture, "ray_reveal.capped"), 0u) << d_back;
  }
}

// N time samples of an exact picture, edges placed to 3/4 px of 20 px of motion (motion is followed from pixel to
// pixel), and 1e-4 for single precision.
TEST_F(RenderReveal, InGatherIsExactOverAStaticBackground) {
  Striped scene;
  lab::Shot flat = shotOf("bar", 144, 4, {{"left", 48}, {"right", 96}, {"background", .25}});
  Strips strips{{48, 96, 20, {1}}, {-kInfinity, kInfinity, 0, {.25}}};
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture =
        render(with(flat, hybridSteps(), {"composite=in_gather", "tile=20", "limit=0.2", "samples=16"}, anchor.name));
    expectWithin(
        colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); },
        [](const Exposure& e) { return e.variation * (1. / 32 + .75 / 20) + 1e-4; }, anchor.name);
    EXPECT_EQ(counterOf(picture, "composite.fallback"), 0u) << anchor.name;
  }
  RowError layered = scene.error(render(scene.hybrid({}))),
           in_gather = scene.error(render(scene.hybrid({"composite=in_gather"})));
  EXPECT_LE(in_gather.rms, layered.rms + 1e-4);
}

// A background of two instances: each becomes visible where the other one was.
TEST_F(RenderReveal, InGatherFollowsABackgroundOfSeveralInstances) {
  lab::Shot shot = shotOf("cards", 128, 4,
                          {{"left0", -80},
                           {"right0", 60},
                           {"z0", 0},
                           {"v0", .2},
                           {"d0", 16},
                           {"left1", 60},
                           {"right1", 208},
                           {"z1", 0},
                           {"v1", .8},
                           {"d1", 16}});
  Strips strips{{-kInfinity, 60, 16, {.2}}, {-kInfinity, kInfinity, 16, {.8}}};
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture =
        render(with(shot, hybridSteps(), {"composite=in_gather", "tile=20", "limit=0.2", "samples=16"}, anchor.name));
    expectWithin(
        colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); },
        [](const Exposure& e) { return e.variation * (1. / 32 + .5 / 16) + 1e-4; }, anchor.name);
  }
}

// Bar and background move together, both striped: coverage and background are fully correlated. Reading both layers per
// time sample gives the exact picture, up to 32 samples (.0069/.016 in docs/derivations.md) and edges placed by pixels.
// The product of two means is off by .15 even with perfect layers. In addition, alpha_over blurs only the revealed part
// of the background, although the exact mean extends beyond the silhouette.
TEST_F(RenderReveal, CompositesOnCorrelatedStripes) {
  Striped scene{20, 20};
  auto errorOf = [&](const char* composite) {
    std::string chosen = fmt::format("composite={}", composite);
    return scene.error(render(scene.hybrid({"mask=paper", "edge=id", "own_edge=true", chosen})));
  };
  double product = 0;
  for (int x = Striped::kFirst; x < Striped::kLast; ++x)
    product = std::max(product, std::abs(alphaOverAt(scene.strips(), kCloseAnchor, x) -
                                         exposeCentre(scene.strips(), kCloseAnchor, x).colour));
  EXPECT_NEAR(product, .15, .01);
  RowError alpha_over = errorOf("alpha_over");
  for (const char* composite : {"layered", "in_gather"}) {
    RowError error = errorOf(composite);
    EXPECT_LE(error.rms, .01) << composite;
    EXPECT_LE(error.max, .033) << composite;
    EXPECT_GE(alpha_over.rms, 4 * error.rms) << composite;
    printed("correlated", {error.rms, error.max});
  }
  EXPECT_GE(alpha_over.max, .8 * product);
  printed("correlated", {alpha_over.rms, alpha_over.max, product});
}

}  // namespace render_reveal_test
}  // namespace strobe::oracle
