// SPDX-License-Identifier: MIT
// Formats and depth encodings in the pipelines: every image with displacements, colours or depths between passes
// follows them, at the precision that defines the format, and nothing else changes.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"
#include "plan/canonical.h"
#include "plan/formats.h"
#include "script/evaluate.h"

namespace strobe::oracle {
namespace render_stored_test {

constexpr double kHalf = 0x1p-11;              // relative error of half floats, rounded to the nearest
constexpr double kTwoDivisions = 5 * 0x1p-23;  // 2.5 units in the last place each, on any device

// All options at once, so that the hybrid's shaders are compiled only for these and for the defaults.
const std::vector<std::string> kOther = {"velocity_format=fp16", "color_format=fp16", "depth_encoding=reversed"};

struct Kept {
  std::string port;
  std::string kind;  // "velocity", "color", "depth"
};

// Images that a pipeline keeps between passes, with settings that need them.
struct Keeper {
  std::string pipeline;
  std::vector<std::string> settings;
  std::vector<Kept> kept;
};

const std::vector<Kept> kSeen = {
    {"gbuffer.velocity", "velocity"}, {"gbuffer.depth", "depth"}, {"shade.color", "color"}};
const std::vector<Kept> kRevealed = {
    {"ray_reveal.velocity", "velocity"}, {"ray_reveal.depth", "depth"}, {"ray_reveal.color", "color"}};

std::vector<Kept> joined(std::vector<Kept> list, const std::vector<Kept>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

std::vector<Keeper> keepers() {
  std::vector<Kept> parts = {{"segments.velocity_pre", "velocity"},
                             {"segments.velocity_post", "velocity"},
                             {"revealed_segments.velocity_pre", "velocity"},
                             {"revealed_segments.velocity_post", "velocity"}};
  std::vector<Kept> blurred = {{"gather_raster.blurred", "color"}, {"gather_revealed.blurred", "color"}};
  std::vector<Keeper> list = {
      {"mcguire2012", {}, kSeen},
      {"guertin2014", {}, kSeen},
      {"jimenez2014", {}, kSeen},
      {"ue4", {}, kSeen},
      {hybridSteps(), {"mask=all"}, joined(kSeen, kRevealed)},
      {hybridSteps(), {"mask=all", "range=split"}, joined(kSeen, parts)},
  };
  for (const char* weights : {"uniform", "mcguire2012", "guertin2014", "jimenez2014"})
    list.push_back({hybridSteps(), {"mask=all", "composite=alpha_over", fmt::format("weights={}", weights)}, blurred});
  return list;
}

lab::Shot crowd(const Keeper& keeper, std::vector<std::string> more) {
  lab::Shot shot = shotOf("crowd", 48, 32);
  shot.sets.clear();
  more.insert(more.end(), keeper.settings.begin(), keeper.settings.end());
  shot = with(shot, keeper.pipeline, more, "centre");
  for (const Kept& one : keeper.kept) shot.taps.push_back(one.port);
  return shot;
}

std::string name(const Keeper& keeper) {
  return fmt::format("{} {}", keeper.pipeline, fmt::join(keeper.settings, " "));
}

class RenderStored : public RenderTest {
 protected:
  static plan::Plan planOf(lab::Shot shot) {
    bench().scene(shot);
    plan::PipelineDesc pipeline = script::evaluatePipeline(bench().home(), {shot.pipeline, shot.sets});
    return lab::planOf(shot, pipeline, bench().chooseBackend("auto"));
  }
};

// Expects each value within `relative` of the exact one, and infinite values unchanged.
void expectClose(const image::Image& exact, const image::Image& stored, double relative, const std::string& what) {
  ASSERT_EQ(exact.values.size(), stored.values.size()) << what;
  double worst = 0;
  for (size_t i = 0; i < exact.values.size(); ++i) {
    if (std::isinf(exact.values[i])) ASSERT_EQ(exact.values[i], stored.values[i]) << what;
    else
      worst = std::max(
          worst, std::abs(double(stored.values[i]) - exact.values[i]) - relative * std::abs(double(exact.values[i])));
  }
  EXPECT_LE(worst, 0x1p-25) << what;  // half a step of the half floats below 2^-14
}

// Images of the passes that shade and project are rounded once from fp32.
TEST_F(RenderStored, ShadedAndProjectedImagesAreRoundedOnce) {
  for (const Keeper& keeper : keepers()) {
    if (name(keeper).find('=') != std::string::npos && name(keeper) != hybridSteps() + " mask=all") continue;
    lab::Picture exact = render(crowd(keeper, {}));
    lab::Picture half = render(crowd(keeper, kOther));
    for (const Kept& one : keeper.kept)
      expectClose(exact.frame.taps.at(one.port).floats, half.frame.taps.at(one.port).floats,
                  one.kind == "depth" ? kTwoDivisions : kHalf, name(keeper) + " " + one.port);
  }
}

TEST_F(RenderStored, ImagesBetweenPassesHaveTheChosenFormat) {
  for (const Keeper& keeper : keepers()) {
    plan::Plan exact = planOf(crowd(keeper, {}));
    plan::Plan half = planOf(crowd(keeper, {"velocity_format=fp16", "color_format=fp16"}));
    for (const Kept& one : keeper.kept) {
      std::string full_format = one.kind == "velocity" ? "rg32f" : one.kind == "color" ? "rgba32f" : "r32f";
      std::string half_format = one.kind == "velocity" ? "rg16f" : one.kind == "color" ? "rgba16f" : "r32f";
      EXPECT_EQ(exact.images.at(size_t(plan::findImage(exact, one.port))).format, full_format) << name(keeper);
      EXPECT_EQ(half.images.at(size_t(plan::findImage(half, one.port))).format, half_format) << name(keeper);
    }
    EXPECT_LT(plan::bytesAliased(half), plan::bytesAliased(exact)) << name(keeper);
    const std::string& picture = half.images[size_t(half.outputs.front().second)].format;
    EXPECT_EQ(half.outputs.front().first, "color");
    EXPECT_EQ(picture, "rgba32f") << name(keeper);
  }
}

// Only normals and the picture are images of full resolution with two or four 32-bit floats. A new pass that keeps
// colours or displacements in fp32 fails this test.
const char* const kOpenPicture = "composite.blurred";  // the picture before rays add samples

TEST_F(RenderStored, NoOtherImageIsInSinglePrecision) {
  for (const Keeper& keeper : keepers()) {
    plan::Plan plan = planOf(crowd(keeper, {"velocity_format=fp16", "color_format=fp16"}));
    int picture = plan.outputs.front().second;
    for (size_t i = 0; i < plan.images.size(); ++i) {
      const plan::VirtualImage& image = plan.images[i];
      bool wide = image.format == "rgba32f" || image.format == "rg32f";
      bool known = int(i) == picture || image.name == "gbuffer.normal" || image.name == kOpenPicture;
      EXPECT_TRUE(known || !wide || image.divide != 1) << name(keeper) << ": " << image.name << " is " << image.format;
    }
  }
}

void expectSkyWhereNothingIs(const lab::Picture& picture, const std::string& what) {
  const image::Image& depth = imageOf(picture, "depth");
  const auto& id = picture.frame.outputs.at("id").uints;
  size_t skies = 0;
  for (size_t i = 0; i < depth.values.size(); ++i) {
    bool sky = id.values[2 * i] == 0;
    skies += sky;
    ASSERT_EQ(std::isinf(depth.values[i]), sky) << what;
  }
  EXPECT_GT(skies, 0u);
  EXPECT_EQ(counterOf(picture, "gbuffer.depth_lost"), 0u) << what;
}

TEST_F(RenderStored, SkySurvivesEveryEncoding) {
  for (const char* encoding : {"linear", "reversed", "inverse", "unorm24"})
    expectSkyWhereNothingIs(render(crowd({"mcguire2012", {}, {}}, {fmt::format("depth_encoding={}", encoding)})),
                            encoding);
}

TEST_F(RenderStored, PixelsWithoutARevealedSurfaceStayEmpty) {
  lab::Picture picture = render(crowd({hybridSteps(), {"mask=all"}, kRevealed}, kOther));
  expectSkyWhereNothingIs(picture, "hybrid");
  const image::Image& valid = imageOf(picture, "revealed_valid");
  const image::Image& behind = imageOf(picture, "revealed_depth");
  size_t nothing = 0;
  for (size_t i = 0; i < valid.values.size(); ++i) {
    nothing += valid.values[i] < 0.5f;
    ASSERT_EQ(behind.values[i] == 0, valid.values[i] < 0.5f) << i;
  }
  EXPECT_GT(nothing, 0u);
}

// A bar moves by d. Half floats round 100.03 px to 100 (steps of 1/16) and 600.2 px to 600 (steps of 1/2).
TEST_F(RenderStored, DisplacementsHaveTheStepsOfHalfFloats) {
  for (auto [d, expected] :
       {std::pair{100.03, 100.0}, {100.04, 100.0625}, {600.2, 600.0}, {600.3, 600.5}, {0.3, 0.300048828125}}) {
    lab::Picture picture = render(
        with(shotOf("bar", 64, 4, {{"d_f", d}, {"left", 16}, {"right", 48}}), "mcguire2012", {"velocity_format=fp16"}));
    EXPECT_EQ(imageOf(picture, "velocity").at(32, 2, 0), float(expected)) << d;
  }
}

TEST_F(RenderStored, OverflowIsClampedAndCounted) {
  lab::Shot fast = shotOf("bar", 64, 4, {{"d_f", 100000}, {"left", 16}, {"right", 48}, {"foreground", 100000}});
  lab::Picture exact = render(with(fast, "mcguire2012"));
  EXPECT_NEAR(imageOf(exact, "velocity").at(32, 2, 0), 100000, 1);
  EXPECT_EQ(counterOf(exact, "gbuffer.velocity_clamped") + counterOf(exact, "shade.color_clamped"), 0u);
  lab::Shot half = with(fast, "mcguire2012", {"velocity_format=fp16", "color_format=fp16"});
  half.taps = {"shade.color"};
  lab::Picture picture = render(half);
  EXPECT_EQ(imageOf(picture, "velocity").at(32, 2, 0), 65504);
  EXPECT_EQ(picture.frame.taps.at("shade.color").floats.at(32, 2, 0), 65504);
  EXPECT_EQ(counterOf(picture, "gbuffer.velocity_clamped"), 32u * 4);
  EXPECT_EQ(counterOf(picture, "shade.color_clamped"), 32u * 4);
  lab::Shot largest = shotOf("bar", 64, 4, {{"left", 16}, {"right", 48}, {"foreground", 65504}});
  EXPECT_EQ(counterOf(render(with(largest, "mcguire2012", {"color_format=fp16"})), "shade.color_clamped"), 0u);
}

// The bar is 100 units from a camera with a near distance of 1, the background 110: 1 - n/z is exact to half a step.
TEST_F(RenderStored, OrthographicDepthsUseTheSameFormulas) {
  lab::Shot shot = shotOf("bar", 64, 4, {{"left", 16}, {"right", 48}});
  const image::Image exact = imageOf(render(with(shot, "mcguire2012")), "depth");
  EXPECT_NEAR(exact.at(32, 2, 0), 100, 1e-3);
  const double half_step = 110 * 0x1p-25;
  for (auto [encoding, relative] :
       {std::pair{"reversed", kTwoDivisions}, {"inverse", kTwoDivisions}, {"unorm24", half_step + 2 * kTwoDivisions}}) {
    lab::Shot encoded = with(shot, "mcguire2012", {fmt::format("depth_encoding={}", encoding)});
    expectClose(exact, imageOf(render(encoded), "depth"), relative, encoding);
  }
}

// The blur is a mean of taps. Rounding each colour by at most 2^-11 of itself changes a pixel by at most that share of
// the brightest tap. Depths and displacements do not change.
TEST_F(RenderStored, PictureErrorIsBoundedByColourRounding) {
  for (const char* pipeline : {"mcguire2012", "guertin2014", "jimenez2014"}) {
    Keeper keeper{pipeline, {}, {}};
    lab::Picture full = render(crowd(keeper, {})), half = render(crowd(keeper, {"color_format=fp16"}));
    double brightest = 0;
    for (float value : colorOf(full).values) brightest = std::max(brightest, double(value));
    EXPECT_GT(rmsDifference(colorOf(full), colorOf(half)), 0) << pipeline;
    EXPECT_LE(oracle::largestDifference(colorOf(full), colorOf(half)), kHalf * brightest * 2) << pipeline;
    EXPECT_TRUE(identical(imageOf(full, "velocity"), imageOf(half, "velocity"))) << pipeline;
    EXPECT_TRUE(identical(imageOf(full, "depth"), imageOf(half, "depth"))) << pipeline;
  }
}

// Static pixels are copied: with half floats the picture equals the stored colours, bit for bit.
TEST_F(RenderStored, StaticPicturesEqualTheStoredColours) {
  for (const char* pipeline : {"mcguire2012", "guertin2014", "jimenez2014", "ue4", "hybrid", "hybrid_layered"}) {
    lab::Shot shot = crowd({pipeline, {}, {{"shade.color", "color"}}}, kOther);
    shot.exposure = 0;
    lab::Picture picture = render(shot);
    EXPECT_TRUE(identical(colorOf(picture), picture.frame.taps.at("shade.color").floats)) << pipeline;
  }
}

}  // namespace render_stored_test
}  // namespace strobe::oracle
