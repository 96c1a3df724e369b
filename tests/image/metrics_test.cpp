// SPDX-License-Identifier: MIT
// Error metrics compared with hand-computed values and with scikit-image (see skimage_reference.py).
#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/json.h"
#include "base/process.h"
#include "common/refusal.h"
#include "common/source.h"
#include "common/temporary_folder.h"
#include "image/comparison.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"

using namespace strobe;
using namespace strobe::image;

namespace metrics_test {

// The same noise on every machine: a 32-bit linear congruential generator.
struct Noise {
  uint32_t state = 5;
  float next() {
    state = state * 1664525u + 1013904223u;
    return float(state >> 8) / 16777216.0f;
  }
};

// 8-bit display values: soft shapes with added `noise`.
Image pattern(int width, int height, float noise) {
  Noise random;
  Image display(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        float value = 0.5f + 0.3f * std::sin(0.13f * x * (c + 1)) * std::cos(0.07f * y) + (x > y ? 0.15f : 0.0f);
        value += noise * (random.next() - 0.5f);
        display.at(x, y, c) = std::round(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255) / 255;
      }
  return display;
}

Image pixels(std::vector<float> values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  image.values = std::move(values);
  return image;
}

// Output of a shell command; empty if it fails.
std::optional<std::string> outputOf(const std::string& line) {
  ProgramEnd end = run({.arguments = {"sh", "-c", line}});
  if (!end.succeeded()) return std::nullopt;
  return end.output;
}

// Result of skimage_reference.py, run with the first Python that has the modules.
std::optional<Json> fromPython(const std::string& arguments) {
  Path script = sourceFolder() / "tests/image/skimage_reference.py";
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (auto text = outputOf(fmt::format("{} '{}' {}", python, script.string(), arguments))) return Json::parse(*text);
  return std::nullopt;
}

TEST(Metrics, MatchHandComputedValues) {
  Image test = pixels({0.5f, 0.25f, 0}), reference = pixels({0.25f, 0.25f, 0.5f});
  EXPECT_DOUBLE_EQ(meanSquaredError(test, reference), (0.0625 + 0.25) / 3);
  EXPECT_DOUBLE_EQ(rootMeanSquaredError(test, reference), std::sqrt((0.0625 + 0.25) / 3));
  EXPECT_DOUBLE_EQ(relativeMse(test, reference), (0.0625 / 0.0725 + 0.25 / 0.26) / 3);
  EXPECT_DOUBLE_EQ(smape(test, reference), (0.25 / 0.76 + 0.5 / 0.51) / 3);
  EXPECT_EQ(smape(pixels({0}), pixels({0})), 0);
}

TEST(Metrics, OfEqualImagesAreExact) {
  Image image = pattern(40, 30, 0.1f);
  EXPECT_EQ(meanSquaredError(image, image), 0);
  EXPECT_EQ(psnr(image, image), INFINITY);
  EXPECT_DOUBLE_EQ(*ssim(image, image), 1);
  EXPECT_EQ(smape(image, image), 0);
  EXPECT_EQ(temporalError(image, image, image, image), 0);
}

TEST(Metrics, PsnrMatchesAKnownError) {
  // Encoded values differ by 0.1: MSE 0.01, 20 dB. Decoding and encoding in float has a relative error of 1e-6.
  Image test(8, 8, 3, decodeSrgb(0.6f)), reference(8, 8, 3, decodeSrgb(0.5f));
  EXPECT_NEAR(psnr(test, reference), 20, 1e-4);
  Image bright(8, 8, 3, 50.0f), white(8, 8, 3, 1.0f);
  EXPECT_EQ(psnr(bright, white), INFINITY);
}

TEST(Metrics, TrimmedMeanIgnoresOneFirefly) {
  Image reference(50, 40, 3), test = reference;
  test.at(7, 7, 0) = 1000;
  EXPECT_GT(relativeMse(test, reference), 1000);
  EXPECT_EQ(trimmedRelativeMse(test, reference), 0);
}

TEST(Metrics, MaskSelectsPixels) {
  Image test = pixels({1, 0, 0.5f, 9}), reference = pixels({0, 0, 0, 0}), mask = pixels({1, 0.4f, 0.5f, 0});
  EXPECT_EQ(countedPixels(test, mask), 2u);
  EXPECT_DOUBLE_EQ(meanSquaredError(test, reference, mask), (1 + 0.25) / 2);
  EXPECT_TRUE(std::isnan(meanSquaredError(test, reference, pixels({0, 0, 0, 0}))));

  Image noisy = pattern(64, 48, 0.3f), clean = pattern(64, 48, 0), all(64, 48, 1, 1.0f);
  EXPECT_EQ(ssim(noisy, clean), ssim(noisy, clean, all));
  Image half = all;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 32; ++x) half.at(x, y, 0) = 0, std::copy_n(clean.pixel(x, y), 3, noisy.pixel(x, y));
  EXPECT_LT(*ssim(noisy, clean, half), *ssim(noisy, clean));
}

TEST(Metrics, AlphaIsNotCompared) {
  Image a(12, 12, 4, 0.5f), b = a;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) b.at(x, y, 3) = 0;
  EXPECT_EQ(meanSquaredError(a, b), 0);
  EXPECT_DOUBLE_EQ(*ssim(a, b), 1);
}

TEST(Metrics, SsimNeedsAFullWindow) {
  EXPECT_FALSE(ssim(Image(10, 40, 3), Image(10, 40, 3)));
  EXPECT_TRUE(ssim(Image(11, 11, 3), Image(11, 11, 3)));
  EXPECT_FALSE(multiScaleSsim(Image(175, 200, 3), Image(175, 200, 3)));
  EXPECT_NEAR(*multiScaleSsim(Image(176, 176, 3), Image(176, 176, 3)), 1, 1e-12);
}

TEST(Metrics, FlickerIsChangeThatTheReferenceLacks) {
  Image dark(4, 4, 1, 0.25f), bright(4, 4, 1, 0.75f);
  EXPECT_DOUBLE_EQ(temporalError(dark, bright, dark, dark), 0.5);
  EXPECT_DOUBLE_EQ(temporalError(dark, bright, dark, bright), 0);
}

TEST(AgainstScikitImage, PsnrAndSsimMatch) {
  const strobe::testing::TemporaryFolder folder;
  Image reference = pattern(200, 180, 0), test = pattern(200, 180, 0.25f);
  writePng(folder.path() / "reference.png", reference);
  writePng(folder.path() / "test.png", test);
  auto expected = fromPython(fmt::format("png '{0}/test.png' '{0}/reference.png'", folder.path().string()));
  if (!expected) GTEST_SKIP() << "no Python with scikit-image, imageio and OpenImageIO (python3-skimage)";
  Image x = decodeSrgb(test), r = decodeSrgb(reference);
  // Decoding and encoding in float has an error of 1e-6 per value, and far less in means.
  EXPECT_NEAR(psnr(x, r), (*expected)["psnr"].get<double>(), 1e-4);
  EXPECT_NEAR(*ssim(x, r), (*expected)["ssim"].get<double>(), 1e-6);
  EXPECT_NEAR(*multiScaleSsim(x, r), (*expected)["ms_ssim"].get<double>(), 1e-6);
  EXPECT_LT(psnr(x, r), 40);
}

// OpenImageIO shares no code with Strobe's writer and names attributes by the standard.
TEST(AgainstOpenImageIo, ExrIsReadAsWritten) {
  const strobe::testing::TemporaryFolder folder;
  ExrFile content;
  Image colour(5, 4, 3), velocity(5, 4, 2);
  colour.at(3, 2, 1) = 0.7f;
  velocity.at(4, 3, 1) = -17.25f;
  content.add("", {"R", "G", "B"}, colour);
  content.add("velocity", {"X", "Y"}, velocity);
  content.add("", {"id"}, UintImage{5, 4, 1, std::vector<uint32_t>(20, 77)});
  content.texts["run"] = "text";
  content.frames_per_second = {24, 1};
  content.camera_from_world = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  writeExr(folder.path() / "a.exr", content);
  auto found = fromPython(fmt::format("exr '{}/a.exr'", folder.path().string()));
  if (!found) GTEST_SKIP() << "no Python with scikit-image, imageio and OpenImageIO (python3-openimageio)";
  EXPECT_EQ((*found)["size"], Json({5, 4}));
  EXPECT_EQ((*found)["compression"], "zip");
  EXPECT_EQ((*found)["formats"]["id"], "uint");
  EXPECT_EQ((*found)["formats"]["velocity.X"], "float");
  EXPECT_FLOAT_EQ((*found)["sums"]["G"].get<float>(), 0.7f);
  EXPECT_EQ((*found)["sums"]["velocity.Y"], -17.25);
  EXPECT_NEAR((*found)["sums"]["id"].get<double>(), 20 * 77, 1e-3);  // converted to float
  EXPECT_EQ((*found)["run"], "text");
  // Row vectors: the translation is the last row.
  EXPECT_EQ((*found)["worldtocamera"],
            Json({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 3.0, 1.0}));
}

TEST(ImageComparison, FilesAreIdentifiedByContent) {
  const strobe::testing::TemporaryFolder folder;
  Image display = pattern(32, 24, 0);
  writePng(folder.path() / "picture.exr", display);
  ComparedPicture png = readPicture(folder.path() / "picture.exr");
  EXPECT_FALSE(png.hdr);
  EXPECT_EQ(png.linear.values, decodeSrgb(display).values);
  EXPECT_THROW(readPicture(folder.path() / "picture.exr", "layer"), Error);

  ExrFile content;
  Image colour(4, 4, 3, 2.0f);
  content.add("", {"R", "G", "B"}, colour);
  writeExr(folder.path() / "good.exr", content);
  EXPECT_TRUE(readPicture(folder.path() / "good.exr").hdr);
  content.channels[1].values[5] = NAN;
  writeExr(folder.path() / "nan.exr", content);
  const std::string refused = strobe::testing::refusalOf([&] { readPicture(folder.path() / "nan.exr"); });
  EXPECT_NE(refused.find("pixel 1,1"), std::string::npos) << refused;
}

TEST(ImageComparison, RefusesAnEmptyMask) {
  EXPECT_THROW(compareImages(Image(4, 4, 3), Image(4, 4, 3), Image(4, 4, 1)), Error);
}

TEST(ImageComparison, HasJsonForEqualImages) {
  Image image(16, 16, 3, 0.5f);
  CompareOptions ldr;
  ldr.hdr = false;
  Json json = compareImages(image, image, {}, ldr).numbers;
  EXPECT_EQ(json["psnr"], "inf");
  EXPECT_EQ(json["ldr_flip"], 0.0);
  EXPECT_TRUE(json["hdr_flip"].is_null());
  EXPECT_FALSE(json.contains("hdr_flip_start"));
  EXPECT_EQ(json["pixels"], 256);
  Json hdr = compareImages(image, image).numbers;
  EXPECT_EQ(hdr["hdr_flip"], 0.0);
  EXPECT_EQ(hdr["hdr_flip_exposures"], 2);
  EXPECT_EQ(hdr["hdr_flip_source"], "reference");
}

}  // namespace metrics_test
