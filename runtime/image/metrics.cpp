// SPDX-License-Identifier: MIT
#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "image/regions.h"
#include "image/tone.h"
#include "math/statistics.h"

namespace strobe::image {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

int colourCount(const Image& image) { return std::min(image.channels, 3); }

void assertSameColours(const Image& test, const Image& reference) {
  STROBE_ASSERT(sameSize(test, reference), "{}x{} and {}x{}", test.width, test.height, reference.width,
                reference.height);
  STROBE_ASSERT(colourCount(test) == colourCount(reference), "{} and {} channels", test.channels, reference.channels);
}

// Mean of error(x, r) over the colour channels of every selected pixel, in reading order.
template <class ErrorOf>
std::vector<double> pixelErrors(const Image& test, const Image& reference, const Image& mask, ErrorOf errorOf) {
  assertSameColours(test, reference);
  std::vector<double> errors;
  errors.reserve(size_t(test.width) * test.height);
  int colours = colourCount(test);
  forPixels(test, mask, [&](int x, int y) {
    double sum = 0;
    for (int c = 0; c < colours; ++c) sum += errorOf(double(test.at(x, y, c)), double(reference.at(x, y, c)));
    errors.push_back(sum / colours);
  });
  return errors;
}

double squaredError(double x, double r) { return (x - r) * (x - r); }
double relativeError(double x, double r) { return (x - r) * (x - r) / (r * r + 0.01); }

// One channel in double precision, for the windowed statistics.
struct Channel {
  int width = 0, height = 0;
  std::vector<double> values;
  double at(int x, int y) const { return values[size_t(y) * width + x]; }
};

Channel planeOf(const Image& image, int c) {
  Channel plane{image.width, image.height, {}};
  for (size_t i = size_t(c); i < image.values.size(); i += image.channels) plane.values.push_back(image.values[i]);
  return plane;
}

Channel product(const Channel& a, const Channel& b) {
  Channel result = a;
  for (size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
  return result;
}

constexpr int kWindow = 11;

std::vector<double> windowTaps() {
  std::vector<double> taps;
  double sum = 0;
  for (int i = 0; i < kWindow; ++i) {
    int offset = i - kWindow / 2;
    taps.push_back(std::exp(-offset * offset / (2 * 1.5 * 1.5)));
    sum += taps.back();
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

// Gaussian mean around every pixel with a window inside the plane. The result is 10 pixels smaller each way.
Channel windowed(const Channel& plane) {
  static const std::vector<double> taps = windowTaps();
  int width = plane.width - kWindow + 1, height = plane.height - kWindow + 1;
  Channel rows{width, plane.height, std::vector<double>(size_t(width) * plane.height, 0.0)};
  for (int y = 0; y < plane.height; ++y)
    for (int k = 0; k < kWindow; ++k)
      for (int x = 0; x < width; ++x) rows.values[size_t(y) * width + x] += taps[k] * plane.at(x + k, y);
  Channel result{width, height, std::vector<double>(size_t(width) * height, 0.0)};
  for (int y = 0; y < height; ++y)
    for (int k = 0; k < kWindow; ++k)
      for (int x = 0; x < width; ++x) result.values[size_t(y) * width + x] += taps[k] * rows.at(x, y + k);
  return result;
}

// The two factors of SSIM around every pixel with a window inside the plane.
struct Similarity {
  Channel luminance, contrast_structure;
};

Similarity similarity(const Channel& test, const Channel& reference) {
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  Channel mean_x = windowed(test), mean_r = windowed(reference);
  Channel xx = windowed(product(test, test)), rr = windowed(product(reference, reference));
  Channel xr = windowed(product(test, reference));
  Similarity result{mean_x, mean_x};
  for (size_t i = 0; i < mean_x.values.size(); ++i) {
    double x = mean_x.values[i], r = mean_r.values[i];
    double variance_x = xx.values[i] - x * x, variance_r = rr.values[i] - r * r, covariance = xr.values[i] - x * r;
    result.luminance.values[i] = (2 * x * r + c1) / (x * x + r * r + c1);
    result.contrast_structure.values[i] = (2 * covariance + c2) / (variance_x + variance_r + c2);
  }
  return result;
}

Channel halved(const Channel& plane) {
  Channel result{plane.width / 2, plane.height / 2, {}};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      result.values.push_back(0.25 * (plane.at(2 * x, 2 * y) + plane.at(2 * x + 1, 2 * y) + plane.at(2 * x, 2 * y + 1) +
                                      plane.at(2 * x + 1, 2 * y + 1)));
  return result;
}

double multiScaleOfChannel(Channel test, Channel reference) {
  constexpr double kWeights[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
  double result = 1;
  for (int scale = 0; scale < 5; ++scale) {
    if (scale > 0) test = halved(test), reference = halved(reference);
    Similarity parts = similarity(test, reference);
    Channel last = product(parts.luminance, parts.contrast_structure);
    double value = mean(scale == 4 ? last.values : parts.contrast_structure.values);
    result *= std::pow(std::max(value, 0.0), kWeights[scale]);
  }
  return result;
}

}  // namespace

double meanSquaredError(const Image& test, const Image& reference, const Image& mask) {
  return mean(pixelErrors(test, reference, mask, squaredError));
}

double rootMeanSquaredError(const Image& test, const Image& reference, const Image& mask) {
  return std::sqrt(meanSquaredError(test, reference, mask));
}

double relativeMse(const Image& test, const Image& reference, const Image& mask) {
  return mean(pixelErrors(test, reference, mask, relativeError));
}

double trimmedRelativeMse(const Image& test, const Image& reference, const Image& mask) {
  std::vector<double> errors = pixelErrors(test, reference, mask, relativeError);
  std::sort(errors.begin(), errors.end());
  size_t dropped = errors.size() / 1000;
  errors.resize(errors.size() - dropped);
  return mean(errors);
}

double smape(const Image& test, const Image& reference, const Image& mask) {
  return mean(pixelErrors(test, reference, mask,
                          [](double x, double r) { return std::abs(x - r) / (std::abs(x) + std::abs(r) + 0.01); }));
}

double psnr(const Image& test, const Image& reference, const Image& mask) {
  return -10 * std::log10(meanSquaredError(encodeSrgb(test), encodeSrgb(reference), mask));
}

std::optional<double> ssim(const Image& test, const Image& reference, const Image& mask) {
  assertSameColours(test, reference);
  if (std::min(test.width, test.height) < kWindow) return std::nullopt;
  Image x = encodeSrgb(test), r = encodeSrgb(reference);
  double sum = 0;
  size_t count = 0;
  for (int c = 0; c < colourCount(test); ++c) {
    Similarity parts = similarity(planeOf(x, c), planeOf(r, c));
    Channel map = product(parts.luminance, parts.contrast_structure);
    for (int py = 0; py < map.height; ++py)
      for (int px = 0; px < map.width; ++px)
        if (isIn(mask, px + kWindow / 2, py + kWindow / 2)) sum += map.at(px, py), ++count;
  }
  return count ? sum / double(count) : kNothing;
}

std::optional<double> multiScaleSsim(const Image& test, const Image& reference) {
  assertSameColours(test, reference);
  if (std::min(test.width, test.height) < kWindow << 4) return std::nullopt;
  Image x = encodeSrgb(test), r = encodeSrgb(reference);
  double sum = 0;
  for (int c = 0; c < colourCount(test); ++c) sum += multiScaleOfChannel(planeOf(x, c), planeOf(r, c));
  return sum / colourCount(test);
}

double temporalError(const Image& test0, const Image& test1, const Image& reference0, const Image& reference1,
                     const Image& mask) {
  assertSameColours(test0, test1);
  assertSameColours(reference0, reference1);
  STROBE_ASSERT(test0.channels == test1.channels && reference0.channels == reference1.channels, "channels differ");
  Image test = test1, reference = reference1;
  for (size_t i = 0; i < test.values.size(); ++i) test.values[i] -= test0.values[i];
  for (size_t i = 0; i < reference.values.size(); ++i) reference.values[i] -= reference0.values[i];
  return mean(pixelErrors(test, reference, mask, [](double x, double r) { return std::abs(x - r); }));
}

size_t countedPixels(const Image& image, const Image& mask) {
  size_t count = 0;
  forPixels(image, mask, [&](int, int) { ++count; });
  return count;
}

double meanOf(const Image& map, const Image& mask) {
  return mean(pixelErrors(map, map, mask, [](double value, double) { return value; }));
}

double largestOf(const Image& map, const Image& mask) {
  std::vector<double> values = pixelErrors(map, map, mask, [](double value, double) { return value; });
  return values.empty() ? kNothing : *std::max_element(values.begin(), values.end());
}

}  // namespace strobe::image
