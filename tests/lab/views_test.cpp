// SPDX-License-Identifier: MIT
// Views compared with the meaning of their colours.
#include "lab/views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/false_colour.h"
#include "image/legend.h"
#include "image/tone.h"

using namespace strobe;
using namespace strobe::lab;
using graph::ReadImage;
using image::Colour;
using image::Image;

namespace views_test {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr Colour kMagenta = {1, 0, 1}, kYellow = {1, 1, 0}, kBlack = {0, 0, 0};

ReadImage floats(const std::string& format, const Image& image) { return {format, image, {}}; }

ReadImage ids(int width, int height, std::vector<uint32_t> values) {
  return {"r32ui", {}, {width, height, 1, std::move(values)}};
}

Colour at(const Image& image, int x, int y) { return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}; }

Image view(const ReadImage& image, const std::string& port, const std::string& kind = "auto") {
  ViewOptions options;
  options.kind = kind;
  return shown(image, port, 1, image.floats.width, image.floats.height, options, nullptr);
}

void expectNear(const Colour& a, const Colour& b, float tolerance) {
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

TEST(Views, AutomaticKindFollowsNameAndFormat) {
  Image one(2, 2, 1), two(2, 2, 2), four(2, 2, 4);
  EXPECT_EQ(automaticKind(floats("rgba32f", four), "color"), "colour");
  EXPECT_EQ(automaticKind(floats("rgba32f", four), "gather.blurred"), "colour");
  EXPECT_EQ(automaticKind(floats("rgba32f", four), "gbuffer.normal"), "normal");
  EXPECT_EQ(automaticKind(floats("r32f", one), "gbuffer.depth"), "depth");
  EXPECT_EQ(automaticKind(floats("r32f", one), "revealed_depth"), "depth");
  EXPECT_EQ(automaticKind(floats("r32f", one), "spread.weight"), "scalar");
  EXPECT_EQ(automaticKind(floats("r8_unorm", one), "sobel.edge"), "mask");
  EXPECT_EQ(automaticKind(floats("rg32f", two), "tiles.dominant"), "velocity");
  EXPECT_EQ(automaticKind(floats("rg16f", two), "gbuffer.velocity"), "velocity");
  EXPECT_EQ(automaticKind(ids(1, 1, {3}), "gbuffer.id"), "id");
}

// `shown` accepts every kind of the menu and gives a picture of the frame's size.
TEST(Views, MenuHasTheShowableKinds) {
  for (const ReadImage& image : {floats("r32f", Image(3, 2, 1, 0.5f)), floats("rg32f", Image(3, 2, 2, 0.5f)),
                                 floats("rgba32f", Image(3, 2, 4, 0.5f)), ids(3, 2, {0, 1, 2, 3, 4, 5})}) {
    std::vector<std::string> kinds = viewKinds(image);
    EXPECT_EQ(kinds.front(), "auto");
    for (const std::string& kind : kinds) {
      ViewOptions options;
      options.kind = kind;
      Image picture = shown(image, "node.port", 4, 12, 8, options, nullptr);
      EXPECT_EQ(picture.width, 12) << kind;
      EXPECT_EQ(picture.height, 8) << kind;
      EXPECT_EQ(picture.channels, 3) << kind;
      for (float value : picture.values) EXPECT_TRUE(value >= 0 && value <= 1) << kind;
    }
  }
}

// Error within 1/20 of one of 256 screen levels: the view approximates the sRGB curve by a table.
TEST(Views, ColourIsExposedAndEncoded) {
  Image ramp(256, 1, 4);
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 3; ++c) ramp.at(x, 0, c) = float(x * x) / (200.0f * 200.0f) * (c + 1);
  ViewOptions options;
  options.exposure_stops = -1;
  Image picture = shown(floats("rgba32f", ramp), "color", 1, 256, 1, options, nullptr);
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.at(x, 0, c), image::encodeSrgb(ramp.at(x, 0, c) * 0.5f), 0.05 / 255);
}

TEST(Views, SumsAreShownAsMeans) {
  Image sum(1, 1, 4);
  sum.values = {64, 32, 0, 64};
  Image picture = view(floats("rgba32f", sum), "trace.sum_a");
  expectNear(at(picture, 0, 0), {1, image::encodeSrgb(0.5f), 0}, 0.05f / 255);
}

TEST(Views, NormalsAreHalvedAndZeroIsBlack) {
  Image normal(3, 1, 4);
  normal.values = {0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 0};
  Image picture = view(floats("rgba32f", normal), "gbuffer.normal");
  expectNear(at(picture, 0, 0), {0.5f, 0.5f, 1}, 0);
  expectNear(at(picture, 1, 0), {0, 0.5f, 0.5f}, 0);
  expectNear(at(picture, 2, 0), kBlack, 0);
}

TEST(Views, IdsHaveFalseColours) {
  ReadImage image = ids(4, 1, {0, 1, 2, 77});
  Image picture = shown(image, "gbuffer.id", 1, 4, 1, {}, nullptr);
  EXPECT_EQ(picture.values, image::idColours(image.uints).values);
}

TEST(Views, NonFiniteValuesHaveSignalColours) {
  for (const char* kind : {"colour", "normal", "velocity", "arrows", "scalar"}) {
    Image data(4, 1, 4, 0.25f);
    data.at(1, 0, 1) = kNan;
    data.at(2, 0, 0) = kInf;
    data.at(3, 0, 1) = -kInf;
    Image picture = view(floats("rgba32f", data), "node.port", kind);
    EXPECT_EQ(at(picture, 1, 0), kMagenta) << kind;
    EXPECT_EQ(at(picture, 2, 0), kYellow) << kind;
    EXPECT_EQ(at(picture, 3, 0), kYellow) << kind;
    EXPECT_NE(at(picture, 0, 0), kMagenta) << kind;
  }
  Image depth(4, 1, 1, 2);
  depth.values = {2, kNan, kInf, -kInf};
  Image picture = view(floats("r32f", depth), "gbuffer.depth");
  EXPECT_EQ(at(picture, 1, 0), kMagenta);
  EXPECT_EQ(at(picture, 2, 0), kBlack) << "infinite depth of the sky is valid";
  EXPECT_EQ(at(picture, 3, 0), kYellow);
  EXPECT_EQ(at(view(floats("r8_unorm", depth), "node.mask"), 1, 0), kMagenta);
}

TEST(Views, UniformAndNonFiniteImagesAreShown) {
  for (const std::string& kind : viewKinds(floats("r32f", Image(1, 1, 1))))
    for (float value : {kNan, kInf, -kInf, 0.0f, -1.0f, 3e38f})
      view(floats("r32f", Image(240, 130, 1, value)), "gbuffer.depth", kind);
  for (const std::string& kind : viewKinds(floats("rg32f", Image(1, 1, 2))))
    for (float value : {kNan, kInf, -kInf, 0.0f, 3e38f, 1e-30f})
      view(floats("rg32f", Image(240, 130, 2, value)), "gbuffer.velocity", kind);
}

// Orange in the mask for any picture; grey and darker than the picture outside.
TEST(Views, MasksTintTheDimmedPicture) {
  Image mask(2, 1, 1), under(2, 1, 4, 0.5f);
  mask.values = {1, 0};
  Image picture = shown(floats("r8_unorm", mask), "mask", 1, 2, 1, {}, &under);
  Colour tinted = at(picture, 0, 0), dimmed = at(picture, 1, 0);
  EXPECT_GT(tinted[0], tinted[1] + 0.2f);
  EXPECT_GT(tinted[1], tinted[2] + 0.2f);
  EXPECT_NEAR(dimmed[0], dimmed[2], 1e-6);
  EXPECT_LT(dimmed[0], 0.5f * image::encodeSrgb(0.5f));
  EXPECT_GT(dimmed[0], 0.05f);
  Colour alone = at(shown(floats("r8_unorm", mask), "mask", 1, 2, 1, {}, nullptr), 0, 0);
  EXPECT_GT(alone[0], 0.5f);
  ViewOptions bare;
  bare.over = false;
  EXPECT_EQ(at(shown(floats("r8_unorm", mask), "mask", 1, 2, 1, bare, &under), 0, 0), (Colour{1, 1, 1}));
}

// Tiles of 8 pixels in a frame that is not a multiple of 8: each pixel shows the texel of its tile.
TEST(Views, TilesAreEnlargedByNearestLookup) {
  Image tiles(3, 2, 1);
  tiles.values = {0, 1, 2, 3, 4, 5};
  ViewOptions options;
  options.kind = "scalar";
  options.low = 0, options.high = 5;
  Image picture = shown(floats("r32f", tiles), "node.tiles", 8, 20, 13, options, nullptr);
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 20; ++x) {
      const int tile = x / 8 + 3 * (y / 8);
      EXPECT_EQ(at(picture, x, y), image::magma(float(tile) / 5));
    }
}

// Images of fixed size are scaled by an integer factor and centred: 16 x 1 in 100 x 20 is 96 x 6 at (2, 7).
TEST(Views, ImagesOfFixedSizeAreFitted) {
  Image row(16, 1, 1, 1);
  row.values[15] = 0;
  ViewOptions options;
  options.kind = "scalar";
  options.low = 0, options.high = 1;
  Image picture = shown(floats("r32f", row), "node.row", 0, 100, 20, options, nullptr);
  EXPECT_EQ(at(picture, 2, 7), image::magma(1));
  EXPECT_EQ(at(picture, 91, 12), image::magma(1));
  EXPECT_EQ(at(picture, 92, 12), image::magma(0));
  EXPECT_EQ(at(picture, 50, 6), kBlack);
  EXPECT_EQ(at(picture, 50, 13), kBlack);
  EXPECT_EQ(at(shown(floats("r32f", Image(64, 64, 1, 1)), "node.row", 0, 32, 16, options, nullptr), 16, 8),
            image::magma(1));
}

// The wheel has the same colours for displacements as the picture.
TEST(Views, WheelHasTheColoursOfThePicture) {
  Image velocity(320, 200, 2);
  for (int i = 0; i < 320 * 200; ++i) velocity.values[size_t(2 * i)] = 17;
  Image picture = view(floats("rg32f", velocity), "gbuffer.velocity");
  image::Rectangle place = image::placeOf({image::Legend::Kind::wheel, 0, 20, ""}, picture);
  int radius = place.width / 2;
  ASSERT_GT(radius, 8);
  constexpr float kHalfLevel = 0.501f / 255;  // a picture with a legend has 8 bits
  for (vec2 direction : {vec2(1, 0), vec2(0, 1), vec2(-1, 0), vec2(-0.6f, -0.8f)}) {
    vec2 offset = glm::round(direction * (0.7f * radius));
    Image one(1, 1, 2);
    one.values = {offset.x, offset.y};
    Colour expected = at(image::velocityColours(one, float(radius)), 0, 0);
    expectNear(at(picture, place.x + radius + int(offset.x), place.y + radius + int(offset.y)), expected, kHalfLevel);
  }
  // 17 px on a scale of 20: the wheel's colour at 17/20 of its radius to the right.
  Image one(1, 1, 2);
  one.values = {17, 0};
  expectNear(at(picture, 5, 5), at(image::velocityColours(one, 20), 0, 0), kHalfLevel);
}

TEST(Views, SmallPicturesHaveNoLegend) {
  Image velocity(64, 48, 2, 3);
  Image picture = view(floats("rg32f", velocity), "gbuffer.velocity");
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(at(picture, x, y), at(picture, 0, 0));
}

// A displacement of 20 px to the right at the second arrow of the first row (arrows 20 px apart from (10, 5)).
TEST(Views, ArrowsPointAlongTheDisplacement) {
  Image velocity(100, 60, 2);
  velocity.at(30, 5, 0) = 20;
  ViewOptions options;
  options.kind = "arrows";
  options.high = 20;
  Image picture = shown(floats("rg32f", velocity), "gbuffer.velocity", 1, 100, 60, options, nullptr);
  EXPECT_GT(at(picture, 40, 5)[0], 0.8f) << "red is to the right";
  EXPECT_LT(at(picture, 40, 5)[1], 0.2f);
  EXPECT_GT(at(picture, 48, 5)[0], 0.5f);
  EXPECT_EQ(at(picture, 20, 5), kBlack);
  EXPECT_EQ(at(picture, 55, 5), kBlack);
  EXPECT_EQ(at(picture, 40, 25), kBlack);
}

TEST(Views, WipeJoinsLeftAndRightHalves) {
  Image a(100, 4, 3, 0.25f), b(100, 4, 3, 0.75f);
  Image picture = wiped(a, b, 0.4);
  EXPECT_EQ(picture.at(0, 0, 0), 0.25f);
  EXPECT_EQ(picture.at(37, 3, 2), 0.25f);
  EXPECT_EQ(picture.at(42, 3, 2), 0.75f);
  EXPECT_EQ(picture.at(99, 0, 0), 0.75f);
  EXPECT_EQ(wiped(a, b, 1).values, a.values);
  EXPECT_EQ(wiped(a, b, 0).values, b.values);
  EXPECT_EQ(wiped(a, b, -3).values, b.values);
}

TEST(Views, DifferencesSaturateAtOneOverTheGain) {
  Image a(3, 1, 3, 0.5f), b = a;
  for (int c = 0; c < 3; ++c) b.at(1, 0, c) = 0.75f;
  b.at(2, 0, 1) = kNan;
  Image picture = difference(a, b, 4);
  EXPECT_EQ(at(picture, 0, 0), image::magma(0));
  EXPECT_EQ(at(picture, 1, 0), image::magma(1));
  EXPECT_EQ(at(picture, 2, 0), kMagenta);
}

TEST(Views, ScalesEndAtNiceNumbers) {
  EXPECT_DOUBLE_EQ(image::niceCeiling(17), 20);
  EXPECT_DOUBLE_EQ(image::niceCeiling(20), 20);
  EXPECT_DOUBLE_EQ(image::niceCeiling(0.21), 0.5);
  EXPECT_DOUBLE_EQ(image::niceCeiling(51), 100);
  EXPECT_DOUBLE_EQ(image::niceCeiling(0), 1);
  EXPECT_DOUBLE_EQ(image::niceCeiling(NAN), 1);
}

}  // namespace views_test
