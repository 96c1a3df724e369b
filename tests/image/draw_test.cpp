// SPDX-License-Identifier: MIT
// Composing pictures: every pixel lands in its place and no pixel outside is written.
#include "image/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "image/canvas.h"
#include "image/false_colour.h"

using namespace strobe;
using namespace strobe::image;

namespace draw_test {

constexpr Colour kWhite = {1, 1, 1}, kBlack = {0, 0, 0};

Image numbered(int width, int height) {
  Image image(width, height, 3);
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i);
  return image;
}

Colour colourAt(const Image& image, int x, int y) { return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}; }

float sum(const Image& image) {
  float total = 0;
  for (float value : image.values) total += value;
  return total;
}

Image one(std::vector<float> values) {
  Image image(1, 1, static_cast<int>(values.size()));
  image.values = std::move(values);
  return image;
}

TEST(Draw, CropHasThePixelsOfItsArea) {
  Image whole = numbered(9, 7);
  Image part = crop(whole, {2, 3, 4, 2});
  EXPECT_EQ(part.width, 4);
  EXPECT_EQ(part.at(1, 1, 2), whole.at(3, 4, 2));
}

TEST(Draw, CropIsClippedToTheImage) {
  EXPECT_EQ(crop(numbered(9, 7), {-3, 5, 6, 9}).width, 3);
  EXPECT_EQ(crop(numbered(9, 7), {-3, 5, 6, 9}).height, 2);
  EXPECT_THROW(crop(numbered(9, 7), {20, 0, 3, 3}), Error);
}

TEST(Draw, MagnifiedPixelsAreSquares) {
  Image image = numbered(3, 2), large = magnify(image, 4);
  EXPECT_EQ(large.width, 12);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) EXPECT_EQ(colourAt(large, x, y), colourAt(image, x / 4, y / 4));
}

TEST(Draw, TextStaysInItsBox) {
  Canvas canvas(Image(200, 60, 3));
  canvas.text(10, 20, "Strobe µ", 20, kWhite);
  canvas.text(-80, -30, "outside", 20, kWhite);
  Image image = canvas.pixels();
  double width = textWidth("Strobe µ", 20);
  EXPECT_GT(width, 40);
  EXPECT_LT(width, 180);
  EXPECT_GT(sum(image), 100);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 200; ++x) {
      bool inside = y >= 20 && y <= 20 + lineHeight(20) && x >= 9 && x <= 11 + width;
      EXPECT_TRUE(inside || image.at(x, y, 0) == 0) << x << "," << y;
    }
  EXPECT_EQ(textWidth("", 20), 0);
}

TEST(FalseColour, DifferencesAreAbsolute) {
  EXPECT_EQ(absoluteDifference(one({0.5f, 0.25f, 0}), one({0.25f, 0.5f, 0}), 2).values,
            (std::vector<float>{0.5f, 0.5f, 0}));
  EXPECT_EQ(colourAt(differenceHeat(one({0.3f}), one({0.1f}), 2.5f), 0, 0), magma(0.5f));
  EXPECT_EQ(colourAt(heatMap(one({7}), 0, 7), 0, 0), magma(1));
}

TEST(FalseColour, VelocityWheelColoursDirections) {
  auto of = [](float x, float y) { return colourAt(velocityColours(one({x, y}), 10), 0, 0); };
  EXPECT_EQ(of(0, 0), kBlack);
  EXPECT_EQ(of(10, 0), (Colour{1, 0, 0}));
  EXPECT_NEAR(of(5, 0)[0], 0.5f, 1e-6);
  Colour left = of(-10, 0);
  EXPECT_NEAR(left[0], 0, 1e-5);
  EXPECT_NEAR(left[1], 1, 1e-5);
  EXPECT_NEAR(left[2], 1, 1e-5);
  EXPECT_GT(of(20, 0)[1], 0.4f);
}

TEST(FalseColour, NeighbouringIdsDiffer) {
  UintImage ids{200, 1, 1, {}};
  for (uint32_t i = 0; i < 200; ++i) ids.values.push_back(i);
  Image shown = idColours(ids);
  EXPECT_EQ(colourAt(shown, 0, 0), kBlack);
  std::set<Colour> different;
  for (int x = 0; x < 200; ++x) different.insert(colourAt(shown, x, 0));
  EXPECT_EQ(different.size(), 200u);
}

TEST(FalseColour, NearDepthIsPaleAndInfinityIsBlack) {
  Image depth(3, 1, 1);
  depth.values = {1, 10, INFINITY};
  Image shown = depthColours(depth, 1, 10);
  EXPECT_EQ(colourAt(shown, 0, 0), magma(1));
  EXPECT_EQ(colourAt(shown, 1, 0), magma(0.1f));
  EXPECT_EQ(colourAt(shown, 2, 0), kBlack);
}

}  // namespace draw_test
