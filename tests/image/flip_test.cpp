// SPDX-License-Identifier: MIT
// FLIP compared with the published program (version 1.6) on synthetic images, and with the published result of
// nv-flip-rs for its two photographs of a tree.
#include "image/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "base/files.h"
#include "common/home.h"
#include "image/false_colour.h"
#include "image/metrics.h"
#include "image/png.h"
#include "image/tone.h"

using namespace strobe;
using namespace strobe::image;

namespace flip_test {

using Rgb = std::array<float, 3>;
using Formula = std::function<Rgb(int x, int y)>;

// Tolerance of the published values: six digits, reproduced across compilers.
constexpr double kTolerance = 1e-4;

Image make(int width, int height, const Formula& formula) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgb value = formula(x, y);
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = value[c];
    }
  return image;
}

Rgb grey(float value) { return {value, value, value}; }

Image constant(int size, Rgb value) {
  return make(size, size, [=](int, int) { return value; });
}

Image step(int size, int edge, float low = 0, float high = 1) {
  return make(size, size, [=](int x, int) { return grey(x < edge ? low : high); });
}

Image checker(int shift) {
  return make(64, 64, [=](int x, int y) {
    return ((x + shift) / 8 + y / 8) & 1 ? Rgb{0.75f, 0.25f, 0.1f} : Rgb{0.1f, 0.2f, 0.6f};
  });
}

// Coverage of pixel `i` by the half-plane left of an edge that moves from `from` to `to`, averaged over pixel and time.
double coverage(double from, double to, int i) {
  double distance = to - from;
  if (distance == 0) return std::clamp(to - i, 0.0, 1.0);
  auto ramp = [](double u) { return u <= 0 ? 0 : u <= 1 ? u * u / 2 : u - 0.5; };
  return distance * (ramp((to - i) / distance) - ramp((to - i - 1) / distance));
}

// A bar [48,80) over a checkerboard, blurred by a motion of `distance` pixels during the exposure.
Image bar(double distance, float scale = 1) {
  return make(128, 64, [=](int x, int y) {
    double alpha = coverage(80 - distance, 80, x) - coverage(48 - distance, 48, x);
    Rgb front = {0.8f, 0.1f, 0.1f};
    Rgb back = (x / 8 + y / 8) & 1 ? Rgb{0.6f, 0.5f, 0.3f} : Rgb{0.05f, 0.1f, 0.2f};
    Rgb result;
    for (int c = 0; c < 3; ++c) result[c] = scale * float(alpha * front[c] + (1 - alpha) * back[c]);
    return result;
  });
}

void expectMap(const Image& map, double mean, double largest) {
  EXPECT_NEAR(meanOf(map), mean, kTolerance);
  EXPECT_NEAR(largestOf(map), largest, kTolerance);
}

// Value below which pixels contribute `fraction` of the map's sum.
double weightedPercentile(const Image& map, double fraction) {
  std::vector<float> values = map.values;
  std::sort(values.begin(), values.end());
  double total = std::accumulate(values.begin(), values.end(), 0.0), sum = 0;
  for (float value : values)
    if ((sum += value) >= fraction * total) return value;
  return values.back();
}

void expectLdr(const Image& reference, const Image& test, double mean, double largest, double ppd = kPixelsPerDegree) {
  expectMap(ldrFlip(test, reference, ppd), mean, largest);
}

void expectExposures(const Exposures& found, double start, double stop, int count) {
  EXPECT_NEAR(found.start, start, kTolerance);
  EXPECT_NEAR(found.stop, stop, kTolerance);
  EXPECT_EQ(found.count, count);
}

TEST(LdrFlip, ConstantColours) {
  expectLdr(constant(32, grey(0)), constant(32, grey(1)), 0.967388, 0.967388);
  expectLdr(constant(32, grey(0)), constant(32, grey(0.5f)), 0.958551, 0.958551);
  expectLdr(constant(32, grey(0.5f)), constant(32, grey(0.51f)), 0.040722, 0.040722);
  expectLdr(constant(32, {0, 1, 0}), constant(32, {0, 0, 1}), 1.0, 1.0);
  expectLdr(constant(32, {1, 0, 0}), constant(32, {0, 1, 0}), 0.986665, 0.986665);
  expectLdr(constant(32, {1, 0, 0}), constant(32, {0, 0, 1}), 0.965082, 0.965082);
}

TEST(LdrFlip, Steps) {
  expectLdr(step(64, 32), step(64, 33), 0.051732, 0.772917);
  expectLdr(step(64, 32), step(64, 36), 0.126321, 0.986783);
  Image ramp = make(64, 64, [](int x, int) { return grey(std::clamp((x + 0.5f - 24) / 16, 0.0f, 1.0f)); });
  expectLdr(step(64, 32), ramp, 0.184618, 0.979785);
}

TEST(LdrFlip, ColourChecker) {
  expectLdr(checker(0), checker(1), 0.170309, 0.856308);
  expectLdr(checker(0), checker(1), 0.218667, 0.934208, 30);
}

TEST(LdrFlip, OneWhitePixel) {
  Image dot(65, 65, 3);
  for (int c = 0; c < 3; ++c) dot.at(32, 32, c) = 1;
  expectLdr(dot, Image(65, 65, 3), 0.003387, 0.864906);
}

TEST(LdrFlip, BlurredBar) {
  expectLdr(bar(0), bar(16), 0.167080, 0.909500);
  expectLdr(bar(12), bar(16), 0.064987, 0.445844);
}

TEST(LdrFlip, PublishedTreePair) {
  auto data = home().data();
  if (!data || !std::filesystem::exists(*data / "data/flip/tree-ref.png"))
    GTEST_SKIP() << "data/flip/tree-ref.png is not in the folder of shared data (STROBE_DATA)";
  Image reference = decodeSrgb(readPng(*data / "data/flip/tree-ref.png"));
  Image test = decodeSrgb(readPng(*data / "data/flip/tree-test.png"));
  Image map = ldrFlip(test, reference, 67);
  expectMap(map, 0.133285, 0.983044);
  expectMap(ldrFlip(test, reference), 0.133277, 0.983034);
  EXPECT_EQ(*std::min_element(map.values.begin(), map.values.end()), 0);
  EXPECT_NEAR(weightedPercentile(map, 0.25), 0.184924, kTolerance);
  EXPECT_NEAR(weightedPercentile(map, 0.50), 0.333241, kTolerance);
  EXPECT_NEAR(weightedPercentile(map, 0.75), 0.503441, kTolerance);
}

TEST(LdrFlip, IsZeroForEqualImagesAndSymmetric) {
  EXPECT_EQ(largestOf(ldrFlip(bar(16), bar(16))), 0);
  EXPECT_EQ(ldrFlip(bar(16), bar(3)).values, ldrFlip(bar(3), bar(16)).values);
}

TEST(LdrFlip, ClampsAndIgnoresAlpha) {
  Image over = constant(16, grey(7)), white(16, 16, 4, 1.0f);
  white.at(3, 3, 3) = 0;
  EXPECT_EQ(largestOf(ldrFlip(over, white)), 0);
}

TEST(HdrFlip, BrightBarAtGivenExposures) {
  expectMap(hdrFlip(bar(16, 4), bar(0, 4), Exposures{-2, 2, 5}).map, 0.178883, 0.935013);
}

TEST(HdrFlip, BarAtAutomaticExposures) {
  HdrFlip aces = hdrFlip(bar(16), bar(0));
  expectExposures(aces.exposures, 2.0638, 3.0901, 2);
  expectMap(aces.map, 0.161504, 0.855612);
}

TEST(HdrFlip, WideRange) {
  auto ramp = [](float scale) {
    return make(64, 16, [=](int x, int) {
      float v = scale * std::exp2((x - 32) / 4.0f);
      return Rgb{v, 0.5f * v, 0.25f * v};
    });
  };
  HdrFlip result = hdrFlip(ramp(1.1f), ramp(1));
  expectExposures(result.exposures, -5.9012, 1.8488, 8);
  expectMap(result.map, 0.139007, 0.168212);
}

TEST(HdrFlip, StepAndConstant) {
  HdrFlip moved = hdrFlip(step(64, 40, 0.05f, 20), step(64, 32, 0.05f, 20));
  expectExposures(moved.exposures, -3.2386, -3.2386, 2);
  expectMap(moved.map, 0.187065, 0.990574);

  HdrFlip flat = hdrFlip(constant(32, grey(2)), constant(32, grey(1)));
  expectExposures(flat.exposures, 1.0833, 1.0833, 2);
  expectMap(flat.map, 0.144833, 0.144833);
}

TEST(HdrFlip, BlackReferenceAtGivenExposures) {
  expectMap(hdrFlip(constant(16, grey(1)), constant(16, grey(0)), Exposures{-1, 1, 2}).map, 0.965037, 0.965037);
}

// Half of this reference is black; the published program reports no error for it.
TEST(HdrFlip, MostlyBlackReferenceStillShowsErrors) {
  Image reference = step(32, 24), test = step(32, 16);
  HdrFlip result = hdrFlip(test, reference);
  EXPECT_EQ(result.exposures.source, Exposures::Source::positive);
  EXPECT_TRUE(std::isfinite(result.exposures.stop));
  EXPECT_GT(meanOf(result.map), 0.1);

  Image black(32, 32, 3);
  HdrFlip from_test = hdrFlip(test, black);
  EXPECT_EQ(from_test.exposures.source, Exposures::Source::test);
  EXPECT_GT(meanOf(from_test.map), 0.1);

  HdrFlip nothing = hdrFlip(black, black);
  EXPECT_EQ(nothing.exposures.source, Exposures::Source::none);
  EXPECT_EQ(largestOf(nothing.map), 0);
}

TEST(Flip, MapCountsOnlyMaskedPixels) {
  Image map = ldrFlip(step(64, 36), step(64, 32)), mask(64, 64, 1);
  EXPECT_TRUE(std::isnan(meanOf(map, mask)));
  mask.at(34, 5, 0) = 1;
  EXPECT_EQ(meanOf(map, mask), double(map.at(34, 5, 0)));
}

TEST(Flip, ColoursRunFromBlackToPale) {
  Image map(2, 1, 1);
  map.values = {0, 1};
  Image colours = heatMap(map, 0, 1);
  EXPECT_LT(colours.at(0, 0, 0), 0.02f);
  EXPECT_GT(colours.at(1, 0, 0), 0.97f);
}

}  // namespace flip_test
