// SPDX-License-Identifier: MIT
// Properties every blur has, whatever the picture, on lit cards that move in all directions.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

constexpr int kWidth = 64, kHeight = 40, kSamples = 16;

struct Method {
  std::string pipeline;
  std::vector<std::string> settings;

  std::string name() const { return fmt::format("{} {}", pipeline, fmt::join(settings, " ")); }
};
const std::vector<Method> kMethods = {
    {"mcguire2012", {}},
    {"mcguire2012", {"weights=uniform"}},
    {"mcguire2012", {"directions=two"}},
    {"ue4", {}},
    {"jimenez2014", {"count=adaptive", "direction=projected"}},
    {"guertin2014", {"second_share=variance", "tile_rule=sign"}},
    {"hybrid", {"preset=seed"}},
    {"hybrid", {"preset=seed", "weights=guertin2014", "directions=two"}},
    {"hybrid", {"preset=seed_linear"}},
    {"hybrid", {"preset=best"}},
    {"hybrid", {"composite=in_gather"}},
};

// Tiles that divide the picture, and nothing that reaches the limit (16 px).
lab::Shot shotBy(const Method& method, const Numbers& numbers = {}, const std::string& anchor = "close") {
  lab::Shot shot = with(shotOf("crowd", kWidth, kHeight, numbers), method.pipeline, method.settings, anchor);
  return with(shot, method.pipeline, {"tile=8", "limit=0.25"});
}

image::Image mirrored(const image::Image& picture) {
  image::Image result = picture;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < picture.channels; ++c) result.at(x, y, c) = picture.at(picture.width - 1 - x, y, c);
  return result;
}

int countDifferent(const image::Image& a, const image::Image& b, double tolerance) {
  int count = 0;
  for (size_t i = 0; i < a.values.size(); i += size_t(a.channels)) {
    bool same = true;
    for (size_t c = i; c < i + 3; ++c) same = same && std::abs(double(a.values[c]) - b.values[c]) <= tolerance;
    count += !same;
  }
  return count;
}

class RenderInvariants : public RenderTest {
 protected:
  image::Image colorBy(const Method& method, const Numbers& numbers = {}, const std::string& anchor = "close") {
    return colorOf(render(shotBy(method, numbers, anchor)));
  }
  image::Image sharp(const Numbers& numbers = {}) {
    return colorOf(render(with(shotOf("crowd", kWidth, kHeight, numbers), "none")));
  }
};

TEST_F(RenderInvariants, TheSceneIsBlurred) {  // or the rest would mean nothing
  for (const Method& method : kMethods) EXPECT_GE(rmsDifference(colorBy(method), sharp()), .01) << method.name();
}

TEST_F(RenderInvariants, ConstantColourStays) {
  for (const Method& method : kMethods) {
    image::Image color = colorBy(method, {{"value", .7}});
    double ulp = std::nextafter(.7f, 1.f) - .7f;
    for (size_t i = 0; i < color.values.size(); ++i) {
      if (i % 4 == 3) continue;
      ASSERT_NEAR(color.values[i], .7f, 2 * ulp * kSamples) << method.name() << " " << i / 4;
    }
  }
}

TEST_F(RenderInvariants, NothingThatMovesIsNothingThatChanges) {
  image::Image still = sharp({{"speed", 0}});
  for (const Method& method : kMethods) {
    EXPECT_TRUE(identical(colorBy(method, {{"speed", 0}}), still)) << method.name();
    lab::Shot shot = shotBy(method);
    shot.exposure = 0;
    EXPECT_TRUE(identical(colorOf(render(shot)), sharp())) << method.name() << " exposure 0";
  }
}

// Rounding of a mirrored projection may put a tap on the other side of half a pixel; it may not change the rule.
TEST_F(RenderInvariants, MirroredScenesGiveMirroredPictures) {
  for (const Method& method : kMethods)
    for (const char* anchor : {"close", "centre"}) {
      image::Image picture = colorBy(method, {}, anchor), other = mirrored(colorBy(method, {{"mirror", -1}}, anchor));
      EXPECT_LE(countDifferent(picture, other, 1e-5), 0) << method.name() << " " << anchor;
    }
}

TEST_F(RenderInvariants, TimeRunsBothWays) {
  for (const Method& method : kMethods) {
    image::Image forward = colorBy(method, {}, "close"), backward = colorBy(method, {{"speed", -1}}, "open");
    EXPECT_LE(countDifferent(forward, backward, 1e-5), 0) << method.name();
  }
}

TEST_F(RenderInvariants, ScalesByPowersOfTwoAreBitIdentical) {
  for (const Method& method : kMethods)
    for (double scale : {1. / 4096, 1024.}) {
      image::Image one = colorBy(method), other = colorBy(method, {{"scale", scale}});
      EXPECT_TRUE(identical(one, other)) << method.name() << " " << scale << " " << countDifferent(one, other, 0);
    }
}

TEST_F(RenderInvariants, WithoutRaysTheHybridIsItsPostProcess) {
  const std::pair<Method, Method> pairs[] = {
      {{"hybrid", {"preset=seed", "mask=none"}}, {"mcguire2012", {}}},
      {{"hybrid", {"preset=seed_linear", "mask=none"}}, {"mcguire2012", {"weights=uniform"}}},
      {{"hybrid", {"preset=seed_linear", "mask=none", "tiles=union"}}, {"mcguire2012", {"weights=uniform"}}},
      {{"hybrid", {"preset=seed", "mask=none", "weights=jimenez2014"}}, {"jimenez2014", {"cheap=false"}}},
      {{"hybrid", {"preset=seed", "mask=none", "weights=guertin2014"}},
       {"guertin2014", {"directions=one", "uniform_path=false"}}},
  };
  for (const auto& [hybrid, post_process] : pairs)
    for (const Anchor& anchor : anchors())
      EXPECT_TRUE(identical(colorBy(hybrid, {}, anchor.name), colorBy(post_process, {}, anchor.name))) << hybrid.name();
}

TEST_F(RenderInvariants, FiniteStaysFinite) {
  for (const Method& method : kMethods) {
    image::Image bright = colorBy(method, {{"brightness", 2e6}});
    for (float value : bright.values) ASSERT_TRUE(std::isfinite(value)) << method.name();
  }
}

}  // namespace
}  // namespace strobe::oracle
