// SPDX-License-Identifier: MIT
// Data windows, display windows and chromaticities of OpenEXR files written by Strobe and by OpenImageIO.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/files.h"
#include "base/process.h"
#include "common/refusal.h"
#include "common/temporary_folder.h"
#include "image/comparison.h"
#include "image/exr.h"

namespace strobe::image {
namespace exr_windows_test {

Image squareOnRamp(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, c) = x >= 12 && x < 22 && y >= 10 && y < 20 ? 2.0f : 0.1f + 0.02f * float(x + c);
  return image;
}

ExrFile fileOf(const Image& image, int x = 0, int y = 0, int display_width = 0, int display_height = 0) {
  ExrFile content;
  content.add("", {"R", "G", "B"}, image);
  content.x = x, content.y = y, content.display_width = display_width, content.display_height = display_height;
  return content;
}

// The image with a border of value 7, `border` pixels wide.
Image bordered(const Image& image, int border) {
  Image larger(image.width + 2 * border, image.height + 2 * border, 3, 7.0f);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) larger.at(x + border, y + border, c) = image.at(x, y, c);
  return larger;
}

class ExrWindows : public ::testing::Test {
 protected:
  ComparedPicture read(const ExrFile& content) const {
    Path file = folder_.path() / "a.exr";
    writeExr(file, content);
    return readPicture(file);
  }

  static Json compared(ComparedPicture test, ComparedPicture reference, ComparedPicture mask = {}) {
    alignPictures(test, reference, mask);
    return compareImages(test.linear, reference.linear, mask.linear).numbers;
  }

  static std::string refusal(const ComparedPicture& test, const ComparedPicture& reference) {
    return testing::refusalOf([&] { compared(test, reference); });
  }

  const strobe::testing::TemporaryFolder folder_;
  const Image image_ = squareOnRamp(40, 30);
  const ComparedPicture plain_ = read(fileOf(image_));
};

TEST_F(ExrWindows, OverscanIsNotCompared) {
  ComparedPicture overscan = read(fileOf(bordered(image_, 5), -5, -5, 40, 30)), plain = plain_, none;
  EXPECT_EQ(compared(plain_, overscan)["mse"], 0);
  EXPECT_EQ(compared(overscan, plain_)["pixels"], size_t(40 * 30));
  alignPictures(plain, overscan, none);
  ASSERT_EQ(overscan.notes.size(), 1u);
  EXPECT_EQ(overscan.notes[0],
            "800 pixels outside of the display window are not compared: data window -5,-5 to 44,34 in the display "
            "window 0,0 to 39,29");
  EXPECT_TRUE(plain.notes.empty());
}

// Mean squared error computed from the pixels at their shifted positions.
TEST_F(ExrWindows, MovedPixelsAreComparedAtTheirPositions) {
  const int kShift = 10;
  double sum = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      for (int c = 0; c < 3; ++c)
        sum += std::pow(image_.at(x, y, c) - (x < kShift ? 0 : image_.at(x - kShift, y, c)), 2);
  ComparedPicture moved = read(fileOf(image_, kShift, 0, 40, 30)), plain = plain_, none;
  EXPECT_NEAR(compared(plain_, moved)["mse"].get<double>(), sum / (40 * 30 * 3), 1e-6);
  alignPictures(plain, moved, none);
  EXPECT_EQ(moved.notes.size(), 2u) << "pixels outside the display window, missing pixels";
}

TEST_F(ExrWindows, PartialWindowIsNotStretched) {
  Image half(20, 30, 3);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 20; ++x)
      for (int c = 0; c < 3; ++c) half.at(x, y, c) = image_.at(x + 20, y, c);
  Image mask(40, 30, 1);
  for (int y = 0; y < 30; ++y)
    for (int x = 20; x < 40; ++x) mask.at(x, y, 0) = 1;
  ComparedPicture part = read(fileOf(half, 20, 0, 40, 30)), mask_picture;
  mask_picture.linear = mask, mask_picture.data = mask_picture.display = {0, 0, 40, 30};
  EXPECT_GT(compared(plain_, part)["mse"], 0.01);
  EXPECT_EQ(compared(plain_, part, mask_picture)["mse"], 0);
  EXPECT_EQ(compared(part, part)["pixels"], size_t(20 * 30)) << "equal windows: all pixels of the window";
  EXPECT_EQ(compared(part, part, mask_picture)["pixels"], size_t(20 * 30));
}

TEST_F(ExrWindows, RefusalsNameBothWindows) {
  std::string larger = refusal(plain_, read(fileOf(image_, 0, 0, 50, 40)));
  EXPECT_EQ(larger,
            "the reference has 50x40 pixels (data window 0,0 to 39,29 in the display window 0,0 to 49,39), but the "
            "test image has 40x30 pixels");
  std::string outside = refusal(plain_, read(fileOf(image_, 60, 0, 40, 30)));
  EXPECT_NE(outside.find("data window 60,0 to 99,29 in the display window 0,0 to 39,29"), std::string::npos) << outside;
}

TEST_F(ExrWindows, WindowsAndPrimariesAreWrittenAsRead) {
  ExrFile content = fileOf(image_, -3, 4, 38, 29);
  content.primaries = Primaries{{0.713, 0.293}, {0.165, 0.83}, {0.128, 0.044}, {0.32168, 0.33767}};
  writeExr(folder_.path() / "w.exr", content);
  ExrFile back = readExr(folder_.path() / "w.exr");
  EXPECT_TRUE(back.x == -3 && back.y == 4) << back.x << "," << back.y;
  EXPECT_TRUE(back.display_width == 38 && back.display_height == 29);
  EXPECT_EQ(back.primaries->text(), content.primaries->text());
}

TEST_F(ExrWindows, StatedPrimariesAreConverted) {
  ExrFile content = fileOf(image_);
  content.primaries = Primaries{};
  EXPECT_EQ(read(content).linear.values, image_.values) << "Rec. 709";
  EXPECT_TRUE(read(content).notes.empty());
  content.primaries = Primaries{{0.713, 0.293}, {0.165, 0.83}, {0.128, 0.044}, {0.32168, 0.33767}};
  ComparedPicture acescg = read(content);
  ASSERT_EQ(acescg.notes.size(), 1u);
  EXPECT_NE(acescg.notes[0].find("converted to Rec. 709 from its primaries: red 0.713 0.293"), std::string::npos);
  EXPECT_GT(compared(plain_, acescg)["mse"], 0);
  EXPECT_NEAR(acescg.linear.at(15, 15, 0), 2, 1e-4) << "white stays white";
}

// Data windows written by OpenImageIO.
TEST_F(ExrWindows, MatchOpenImageIO) {
  writeExr(folder_.path() / "a.exr", fileOf(image_));
  auto written = [&](const std::vector<std::string>& how) -> std::optional<ComparedPicture> {
    std::vector<std::string> line = {"oiiotool", folder_ / "a.exr"};
    line.insert(line.end(), how.begin(), how.end());
    line.insert(line.end(), {"-o", folder_ / "b.exr"});
    if (!run({.arguments = line}).succeeded()) return std::nullopt;
    return readPicture(folder_.path() / "b.exr");
  };
  std::optional<ComparedPicture> moved = written({"--origin", "+10+0"});
  if (!moved) GTEST_SKIP() << "no oiiotool (the package openimageio-tools)";
  EXPECT_GT(compared(plain_, *moved)["mse"], 0.1);
  ComparedPicture both = *written({"--origin", "+100+50", "--fullsize", "40x30+100+50"});
  EXPECT_EQ(compared(plain_, both)["mse"], 0);
  ComparedPicture cropped = *written({"--crop", "20x10+5+5"}), shown = plain_, none;
  alignPictures(shown, cropped, none);
  EXPECT_EQ(cropped.linear.at(5, 5, 1), image_.at(5, 5, 1));
  EXPECT_EQ(cropped.linear.at(4, 5, 1), 0);
}

}  // namespace exr_windows_test
}  // namespace strobe::image
