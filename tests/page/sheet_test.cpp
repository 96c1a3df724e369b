// SPDX-License-Identifier: MIT
// A contact sheet: where rows and columns lie, and that nothing is drawn over something else.
#include "page/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace strobe::page {
namespace {

constexpr image::Colour kRed = {1, 0, 0}, kGreen = {0, 1, 0}, kBlue = {0, 0, 1};

bool is(const image::Image& picture, int x, int y, const image::Colour& colour) {
  return picture.at(x, y, 0) == colour[0] && picture.at(x, y, 1) == colour[1] && picture.at(x, y, 2) == colour[2];
}

// The box of all pixels of a colour.
image::Rectangle boxOf(const image::Image& picture, const image::Colour& colour) {
  int left = picture.width, top = picture.height, right = -1, bottom = -1;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (!is(picture, x, y, colour)) continue;
      left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
  return {left, top, right - left + 1, bottom - top + 1};
}

SheetCell cellOf(int width, int height, const image::Colour& colour) { return {image::filled(width, height, colour)}; }

TEST(Sheet, PicturesStandInColumnsAndGrowByWholeFactors) {
  Sheet sheet;
  sheet.parts.push_back(SheetRow{{cellOf(240, 100, kRed), cellOf(200, 50, kGreen)}});
  sheet.parts.push_back(SheetRow{{cellOf(480, 10, kBlue)}});
  image::Image picture = imageOf(sheet);
  image::Rectangle red = boxOf(picture, kRed), green = boxOf(picture, kGreen), blue = boxOf(picture, kBlue);
  EXPECT_EQ(red.width, 480);
  EXPECT_EQ(red.height, 200);
  EXPECT_EQ(green.width, 400) << "twice: a whole factor that fits the column";
  EXPECT_EQ(green.y, red.y);
  EXPECT_GT(green.x, red.x + kSheetColumn);
  EXPECT_GT(blue.y, red.y + red.height) << "below the highest of the row before";
  EXPECT_EQ(picture.width - (green.x + kSheetColumn), red.x) << "equal margins";
}

TEST(Sheet, FramesLieWhereTheyDoInTheSource) {
  SheetCell cell = cellOf(480, 100, kRed);
  cell.frames = {{{100, 20, 50, 30}, kGreen, 2}};
  cell.source_width = 960;
  Sheet sheet;
  sheet.parts.push_back(SheetRow{{cell}});
  image::Image picture = imageOf(sheet);
  image::Rectangle red = boxOf(picture, kRed), green = boxOf(picture, kGreen);
  EXPECT_EQ(green.x - red.x, 50);
  EXPECT_EQ(green.y - red.y, 10);
  EXPECT_EQ(green.width, 25);
  EXPECT_EQ(green.height, 15);
}

TEST(Sheet, TextStandsInPlaceOfAPicture) {
  SheetCell cell = cellOf(480, 300, kRed);
  cell.texts = {"the reference", "its error"};
  Sheet sheet;
  sheet.parts.push_back(SheetRow{{cell, cellOf(480, 300, kGreen)}});
  image::Image picture = imageOf(sheet);
  EXPECT_LE(boxOf(picture, kRed).width, 0) << "no pixel of it";
  EXPECT_EQ(boxOf(picture, kGreen).height, 300);
}

// Ink of a line stays between the margins, however long its text is.
TEST(Sheet, LongTextIsCut) {
  std::string text;
  while (text.size() < 400) text += "wörter ";
  Sheet sheet;
  sheet.parts.push_back(SheetLine{text, 30, Ink::strong});
  sheet.parts.push_back(SheetLabels{{text}, 30, Ink::soft});
  image::Image picture = imageOf(sheet);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < 20; ++x) {
      ASSERT_TRUE(is(picture, x, y, {1, 1, 1}));
      ASSERT_TRUE(is(picture, picture.width - 1 - x, y, {1, 1, 1}));
    }
}

TEST(Sheet, GapsMoveWhatFollows) {
  auto topOf = [](int gap) {
    Sheet sheet;
    sheet.parts = {SheetGap{gap}, SheetRow{{cellOf(480, 5, kRed)}}};
    return boxOf(imageOf(sheet), kRed).y;
  };
  EXPECT_EQ(topOf(40) - topOf(0), 40);
}

}  // namespace
}  // namespace strobe::page
