// SPDX-License-Identifier: MIT
#include "image/regions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/draw.h"

namespace strobe::image {
namespace regions_test {

// Two adjacent pixels with three colour channels and an ignored alpha.
Image pair(std::vector<float> left, std::vector<float> right) {
  Image image(2, 1, 4);
  std::copy(left.begin(), left.end(), image.values.begin());
  std::copy(right.begin(), right.end(), image.values.begin() + 4);
  return image;
}

Image leftMask() {
  Image mask(2, 1, 1);
  mask.values = {1, 0.4f};
  return mask;
}

TEST(Regions, ContrastIsTheRootMeanSquareDeviation) {
  // Deviations from the mean of each channel: 1, 2 and 0.
  EXPECT_DOUBLE_EQ(contrast(pair({0, 1, 5, 0}, {2, 5, 5, 9})), std::sqrt(5.0 / 3));
  EXPECT_EQ(contrast(pair({0, 1, 5, 0}, {2, 5, 5, 9}), leftMask()), 0);
  Image none(2, 1, 1);
  EXPECT_TRUE(std::isnan(contrast(pair({0, 1, 5, 0}, {2, 5, 5, 9}), none)));
}

TEST(Regions, LargestDifferenceHasAPosition) {
  Image a = pair({0, 0, 0, 0}, {0, 0, 0, 0}), b = pair({0, 0.5f, 0, 9}, {0, 0, -2, 0});
  Difference difference = largestDifference(a, b);
  EXPECT_EQ(difference.value, 2);
  EXPECT_EQ(difference.x, 1);
  EXPECT_EQ(largestDifference(a, b, leftMask()).value, 0.5);
  EXPECT_EQ(largestColour(b), 2);
  EXPECT_EQ(largestColour(b, leftMask()), 0.5);
}

TEST(WorstWindow, IsWhereTheMapIsLargest) {
  Image map(20, 10, 1);
  map.at(12, 6, 0) = 1;
  map.at(15, 7, 0) = 1;
  Rectangle worst = worstWindow(map, 4, 3);
  EXPECT_TRUE(worst.x == 12 && worst.y == 5)
      << worst.x << ", " << worst.y << ": the first window that contains both pixels";
  worst = worstWindow(map, 40, 30);
  EXPECT_TRUE(worst.width == 20 && worst.height == 10 && worst.x == 0);
}

TEST(Regions, NanDiffers) {
  Image a = pair({0, 0, 0, 0}, {0, 0, 0, 0}), b = pair({0, NAN, 0, 0}, {0.25f, 0, 0, 0});
  EXPECT_EQ(countDifferent(a, b, 0), 2);
  EXPECT_EQ(countDifferent(a, b, 0.25), 1);
  EXPECT_EQ(countDifferent(a, b, 0.1, leftMask()), 1);
  EXPECT_TRUE(std::isinf(largestDifference(a, b).value));
}

}  // namespace regions_test
}  // namespace strobe::image
