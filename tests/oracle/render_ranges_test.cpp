// SPDX-License-Identifier: MIT
// Sampling ranges: every anchor against the exact exposures of all anchors; the exposure split at the raster time,
// where the velocity changes; and displacements extrapolated from the frame before.
#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "common/refusal.h"
#include "image/regions.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_ranges_test {

constexpr int kWidth = 96, kHeight = 20, kSamples = 16, kMargin = 16;

// The scene `bent` with its parameters (px over the exposure).
struct Bent {
  double before = 20, after = 20, before_y = 0, after_y = 0, bend = 0, d_back = 0;
  double light = .4, dark = .1, top = -8, bottom = 40;

  std::string name() const {
    return fmt::format("({}, {}) ({}, {}) over {}", before, before_y, after, after_y, d_back);
  }
  lab::Shot shot() const {
    return shotOf("bent", kWidth, kHeight,
                  {{"before", before},
                   {"after", after},
                   {"before_y", before_y},
                   {"after_y", after_y},
                   {"bend", bend},
                   {"d_b", d_back},
                   {"light", light},
                   {"dark", dark},
                   {"top", top},
                   {"bottom", bottom}});
  }
  // Linear motion at the velocity before or after the raster time.
  MovingPolygon part(bool is_after) const {
    return {{{30, top}, {62, top}, {62, bottom}, {30, bottom}},
            is_after ? Point{after, after_y} : Point{before, before_y},
            {.9},
            {d_back, 0},
            {light, dark, 8, 0, 0}};
  }
  // Centred exposure: each velocity for one half.
  Exposure exactAt(int x, int y) const {
    Exposure first = exposeCentre(part(false), {-.5, 0}, x, y), second = exposeCentre(part(true), {0, .5}, x, y);
    Exposure both;
    both.colour = (first.colour + second.colour) / 2;
    both.changes = first.changes + second.changes;
    both.jump = std::max(first.jump, second.jump);
    both.variation = first.variation + second.variation;
    return both;
  }
};

using ExactExposure = std::function<Exposure(int x, int y)>;

// Root mean square error without the left and right border, since no filter has surfaces beyond it.
double rmsTo(const image::Image& color, const ExactExposure& exact) {
  double sum = 0;
  for (int y = 0; y < color.height; ++y)
    for (int x = kMargin; x < color.width - kMargin; ++x) sum += std::pow(color.at(x, y, 0) - exact(x, y).colour, 2);
  return std::sqrt(sum / (color.height * (color.width - 2 * kMargin)));
}

// Over a static background of one colour.
const std::vector<Bent> kPlain = {
    {.before = 20, .after = -20, .light = .1},
    {.before = 0, .after = 18, .light = .1},
    {.before = -8, .after = 19, .light = .1},
    {.before = 12, .after = 20, .light = .1},
};
// Over a checker, static or moving.
const std::vector<Bent> kTextured = {
    {.before = 19, .after = -17},
    {.before = 0, .after = 18, .d_back = -12},
    {.before = 14, .after = 3, .before_y = 2, .after_y = 11, .d_back = 6, .top = 5, .bottom = 15},
};

struct Method {
  std::string pipeline;
  std::vector<std::string> settings;

  std::string name() const { return fmt::format("{} {}", pipeline, fmt::join(settings, " ")); }
};
const Method kUniform{"mcguire2012", {"weights=uniform"}}, kLinear{"hybrid", {"preset=text", "weights=uniform"}},
    kBest{"hybrid_layered", {}};
const Method kInGather{hybridSteps(), {"composite=in_gather"}};
const std::vector<Method> kSplitting = {kUniform, kBest, kInGather};

class RenderRanges : public RenderTest {
 protected:
  lab::Picture pictureBy(const Method& method, const lab::Shot& shot, const std::vector<std::string>& more = {},
                         const std::string& anchor = "centre") {
    lab::Shot set = with(shot, method.pipeline, method.settings, anchor);
    set = with(set, method.pipeline, {"tile=16", "limit=0.4"});
    return render(with(set, method.pipeline, more));
  }
  image::Image colorBy(const Method& method, const lab::Shot& shot, const std::vector<std::string>& more = {},
                       const std::string& anchor = "centre") {
    return colorOf(pictureBy(method, shot, more, anchor));
  }
  void checkComposite(const Method& method, const Bent& bent);
};

// Error of time samples and of edges placed to within 3/4 px, the tolerance of layered composites. The picture's
// borders are left out, since the surfaces that enter there are unknown.
void RenderRanges::checkComposite(const Method& method, const Bent& bent) {
  auto exact = [&](int x, int y) { return bent.exactAt(x, y); };
  image::Image split = colorBy(method, bent.shot(), {"range=split"}), inside = split;
  double fastest = std::max(std::hypot(bent.before, bent.before_y), std::hypot(bent.after, bent.after_y));
  auto bound = [&](const Exposure& e) { return e.variation * (1. / (2 * kSamples) + .75 / fastest) + 1e-4; };
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (x < kMargin || x >= kWidth - kMargin) inside.at(x, y, 0) = float(exact(x, y).colour);
  expectWithin(inside, exact, bound, method.name() + " " + bent.name());
  double whole = rmsTo(colorBy(method, bent.shot()), exact);
  EXPECT_GE(whole, 4 * rmsTo(split, exact)) << method.name() << " " << bent.name();
}

lab::Shot crowd(const Numbers& numbers = {}) { return shotOf("crowd", 64, 40, numbers); }

// ------------------------------------------------------------------------------------

TEST_F(RenderRanges, EachAnchorIsNearestToItsOwnExposure) {
  Strips bar{{36, 68, 14, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  lab::Shot shot = shotOf("bar", kWidth, 4, {{"left", 36}, {"right", 68}, {"d_f", 14}});
  const std::vector<Method> methods = {
      {"mcguire2012", {}},         kUniform, {"ue4", {}}, {"guertin2014", {}}, {"jimenez2014", {}},
      {"hybrid", {"preset=text"}}, kLinear,  kBest};
  for (const Method& method : methods) {
    for (const Anchor& anchor : anchors()) {
      image::Image color = colorBy(method, shot, {}, anchor.name);
      auto distance_to = [&](const Anchor& truth) {
        return rmsTo(color, [&](int x, int) { return exposeCentre(bar, truth.window, x); });
      };
      for (const Anchor& other : anchors()) {
        if (other.name == anchor.name) continue;
        EXPECT_LE(distance_to(anchor), .8 * distance_to(other))
            << method.name() << " " << anchor.name << " " << other.name;
      }
    }
  }
}

// ----------------------------------------------------------------------------------------------

TEST_F(RenderRanges, TruthFollowsMotionInTwoSegments) {
  constexpr int kTimes = 128;
  for (const Bent& bent : {kPlain[0], kTextured[2]}) {
    std::vector<std::string> settings = {fmt::format("samples={}", kTimes), "mark_regions=false"};
    lab::Shot shot = with(bent.shot(), "ground_truth", settings, "centre");
    expectWithin(
        colorOf(render(shot)), [&](int x, int y) { return bent.exactAt(x, y); },
        [](const Exposure& e) { return e.variation / (2 * kTimes) + 1e-4; }, bent.name());
  }
}

// Over a static background each tap counts as 1/N of the exposure: as exact as N time samples.
TEST_F(RenderRanges, SplitGatherIsExactForTwoSegments) {
  for (const Bent& bent : kPlain) {
    auto exact = [&](int x, int y) { return bent.exactAt(x, y); };
    image::Image split = colorBy(kUniform, bent.shot(), {"range=split"});
    auto bound = [](const Exposure& e) { return e.variation / (2 * kSamples) + 1e-4; };
    expectWithin(split, exact, bound, bent.name());
    EXPECT_GE(rmsTo(colorBy(kUniform, bent.shot()), exact), 4 * rmsTo(split, exact)) << bent.name();
  }
}

TEST_F(RenderRanges, SplitCompositesAreExactForTwoSegments) {
  for (const Bent& bent : {kPlain[0], kPlain[2]}) checkComposite(kInGather, bent);
  for (const Bent& bent : {kPlain[0], kTextured[0], kTextured[1], kTextured[2]}) checkComposite(kBest, bent);
}

TEST_F(RenderRanges, OneSidedExposuresHaveOneSegment) {
  lab::Shot shot = kTextured[0].shot();
  for (const Method& method : kSplitting)
    for (const char* anchor : {"end", "start"}) {
      image::Image whole = colorBy(method, shot, {}, anchor), split = colorBy(method, shot, {"range=split"}, anchor);
      EXPECT_TRUE(identical(whole, split)) << method.name() << " " << anchor;
    }
}

// The two displacements differ from the single one by rounding, which may move a tap across half a pixel. No path here
// ends on a border of pixels.
TEST_F(RenderRanges, SplittingDoesNotChangeLinearMotion) {
  for (const Method& method : kSplitting)
    for (const lab::Shot& shot : {Bent{.d_back = -7.3}.shot(), crowd()}) {
      image::Image whole = colorBy(method, shot), split = colorBy(method, shot, {"range=split"});
      EXPECT_LE(image::countDifferent(whole, split, 1e-5), 4) << method.name() << " " << shot.scene;
    }
}

// The limit shortens displacements of 28 px to 21.5 px: the last tap lies 7.6 px away along either axis, rounded to 8.
// Longer displacements would move it further.
TEST_F(RenderRanges, SplittingDoesNotChangeShortenedMotion) {
  const lab::Shot shot = Bent{.before_y = 20, .after_y = 20, .light = .1}.shot();
  const std::vector<std::string> shortened = {"limit=0.224", "samples=256"};
  std::vector<std::string> split = shortened;
  split.push_back("range=split");
  const image::Image whole = colorBy(kUniform, shot, shortened);
  EXPECT_EQ(image::countDifferent(whole, colorBy(kUniform, shot, split), 1e-5), 0);
  EXPECT_GT(image::countDifferent(whole, colorBy(kUniform, shot, {"samples=256"}), 1e-5), 0);
}

TEST_F(RenderRanges, PublishedWeightsRefuseSplitRanges) {
  for (const char* weights : {"mcguire2012", "uniform"}) {
    std::string setting = fmt::format("weights={}", weights);
    const std::string refused = testing::refusalOf([&] {
      colorBy({"mcguire2012", {setting}}, crowd(), {"range=split"});
    });
    EXPECT_EQ(refused.find("range = split: weights = mcguire2012") != std::string::npos,
              std::string(weights) == "mcguire2012");
  }
}

// --------------------------------------------------------------------------------

using At = std::function<vec2(int x, int y)>;

// Largest distance between a velocity image and the closed form, over the pixels that `counts` selects.
double farthest(const image::Image& velocity, const At& exact, const std::function<bool(int x, int y)>& counts) {
  double largest = 0;
  int count = 0;
  for (int y = 0; y < velocity.height; ++y)
    for (int x = 0; x < velocity.width; ++x) {
      if (!counts(x, y)) continue;
      ++count;
      vec2 d(velocity.at(x, y, 0), velocity.at(x, y, 1));
      largest = std::max(largest, double(glm::length(d - exact(x, y))));
    }
  EXPECT_GE(count, 50);
  return largest;
}

// With x = v t + `bend` t^2 / 2 (t in exposures) the window yields v + `bend` (open + close) / 2. The frame before, 1/T
// exposures earlier, yields v - `bend` / (2 T).
TEST_F(RenderRanges, ExtrapolationMissesAccelerationByThePredictedAmount) {
  Bent bent{.before = 12, .after = 12, .bend = 5};
  const double exposure = .5;  // T
  auto on_bar = [](int x, int) { return x >= 30 && x < 62; };
  auto beside = [](int x, int) { return x < 30 || x >= 62; };
  for (const char* pipeline : {"mcguire2012", "guertin2014", "jimenez2014", "ue4", "hybrid"}) {
    for (const Anchor& anchor : anchors()) {
      auto velocity = [&](const char* displacement) {
        Method method{pipeline, {fmt::format("displacement={}", displacement)}};
        return imageOf(pictureBy(method, bent.shot(), {}, anchor.name), "velocity");
      };
      double in_window = 12 + 5 * (anchor.window.open + anchor.window.close) / 2, before = 12 - 5 / (2 * exposure);
      image::Image window = velocity("window"), extrapolated = velocity("extrapolated");
      EXPECT_LE(farthest(
                    window, [&](int, int) { return vec2(in_window, 0); }, on_bar),
                1e-3)
          << anchor.name;
      EXPECT_LE(farthest(
                    extrapolated, [&](int, int) { return vec2(before, 0); }, on_bar),
                1e-3)
          << anchor.name;
      EXPECT_LE(farthest(
                    extrapolated, [](int, int) { return vec2(0); }, beside),
                1e-3)
          << anchor.name;
    }
  }
}

TEST_F(RenderRanges, UniformMotionIsExtrapolatedExactly) {
  for (const Anchor& anchor : anchors()) {
    for (const char* output : {"velocity", "revealed_velocity"}) {
      image::Image window = imageOf(pictureBy(kBest, crowd(), {}, anchor.name), output);
      image::Image other = imageOf(pictureBy(kBest, crowd(), {"displacement=extrapolated"}, anchor.name), output);
      EXPECT_LE(oracle::largestDifference(window, other), 1e-3) << anchor.name << " " << output;
    }
  }
}

constexpr double kFocal = 64;  // px, of the scene `crowd`

// Position, in px from the principal point, of the direction at `p` after the camera has turned left by `angle`.
vec2 turned(vec2 p, double angle) {
  double x = p.x / kFocal, y = p.y / kFocal;
  double depth = std::cos(angle) - x * std::sin(angle);
  return float(kFocal) * vec2((x * std::cos(angle) + std::sin(angle)) / depth, y / depth);
}

TEST_F(RenderRanges, SkyMovesWithTheTurningCamera) {
  const double per_frame = 8 * std::numbers::pi / 180, exposure = .5;
  for (const Anchor& anchor : anchors()) {
    for (const char* displacement : {"window", "extrapolated"}) {
      lab::Shot shot = crowd();
      shot.spins = {"camera=0,1,0,8"};
      std::string setting = fmt::format("displacement={}", displacement);
      lab::Picture picture = pictureBy({"mcguire2012", {}}, shot, {setting}, anchor.name);
      auto exact = [&](int x, int y) {
        vec2 p(x + .5 - 32, y + .5 - 20);
        if (displacement == std::string("extrapolated")) return vec2(exposure) * (p - turned(p, -per_frame));
        double over_window = per_frame * exposure;
        return turned(p, over_window * anchor.window.close) - turned(p, over_window * anchor.window.open);
      };
      const image::UintImage& id = picture.frame.outputs.at("id").uints;
      auto sky = [&](int x, int y) { return id.values[(size_t(y) * 64 + size_t(x)) * size_t(id.channels)] == 0; };
      EXPECT_LE(farthest(imageOf(picture, "velocity"), exact, sky), 1e-3) << anchor.name << " " << displacement;
    }
  }
}

// Pixels without a revealed surface have no motion, not even the motion of the sky.
TEST_F(RenderRanges, PixelsWithoutARevealedSurfaceHaveNoMotion) {
  lab::Shot shot = crowd();
  shot.spins = {"camera=0,1,0,8"};
  shot = with(shot, "hybrid_layered", {"range=split"}, "centre");
  shot.taps = {"revealed_segments.velocity_pre", "revealed_segments.velocity_post"};
  const lab::Picture picture = render(shot);
  const image::Image& depth = imageOf(picture, "revealed_depth");
  int there = 0, nothing = 0;
  for (const std::string& tap : shot.taps)
    for (int y = 0; y < depth.height; ++y)
      for (int x = 0; x < depth.width; ++x) {
        const image::Image& d = picture.frame.taps.at(tap).floats;
        const bool moves = d.at(x, y, 0) != 0 || d.at(x, y, 1) != 0;
        EXPECT_EQ(moves, depth.at(x, y, 0) > 0) << tap << ' ' << x << ' ' << y;
        ++(moves ? there : nothing);
      }
  EXPECT_GT(there, 100);
  EXPECT_GT(nothing, 100);
}

// Focal length times the camera's motion over the depth, for every anchor; the sky is static.
TEST_F(RenderRanges, PicturePansWithTheMovingCamera) {
  for (const Anchor& anchor : anchors()) {
    for (const char* displacement : {"window", "extrapolated"}) {
      lab::Shot shot = crowd({{"speed", 0}});
      shot.moves = {"camera=2,-1,0"};
      std::string setting = fmt::format("displacement={}", displacement);
      lab::Picture picture = pictureBy({"mcguire2012", {}}, shot, {setting}, anchor.name);
      auto exact = [&](int x, int y) {
        float depth = imageOf(picture, "depth").at(x, y, 0);
        return std::isinf(depth) ? vec2(0) : vec2(.5 * kFocal / depth) * vec2(-2, -1);
      };
      EXPECT_LE(farthest(imageOf(picture, "velocity"), exact, [](int, int) { return true; }), 1e-3)
          << anchor.name << " " << displacement;
    }
  }
}

// A frame ago the camera was 30 m further ahead, so nearer surfaces were behind it. Their path up to the near plane is
// extrapolated to its full length, without a division by a depth below the near plane.
TEST_F(RenderRanges, SurfacesFromBehindTheCameraStartAtTheNearPlane) {
  lab::Shot shot = crowd({{"speed", 0}});
  shot.moves = {"camera=0,0,30"};
  lab::Picture picture = pictureBy({"mcguire2012", {}}, shot, {"displacement=extrapolated"}, "start");
  const image::Image &depth = imageOf(picture, "depth"), &velocity = imageOf(picture, "velocity");
  const double near = .5 * 1.001, exposure = .5;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 64; ++x) {
      double z = depth.at(x, y, 0);
      if (!(z < 30)) continue;
      double share = (z - near) / 30;
      double expected = -exposure * (x + .5 - 32) * (z / near - 1) / share;
      EXPECT_NEAR(velocity.at(x, y, 0), expected, 1e-3 * std::abs(expected) + 1e-3) << x << " " << y;
    }
}

}  // namespace render_ranges_test
}  // namespace strobe::oracle
