// SPDX-License-Identifier: MIT
#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "math/constants.h"

namespace strobe::image {
namespace {

using Vec3 = std::array<float, 3>;

struct Plane {
  int width, height;
  std::vector<float> values;

  Plane(int w, int h) : width(w), height(h), values(size_t(w) * h, 0.0f) {}
  float* row(int y) { return &values[size_t(y) * width]; }
  const float* row(int y) const { return &values[size_t(y) * width]; }
};

// ---- colour -------------------------------------------------------------------------------------------------------

constexpr Vec3 kWhite = {0.950428545f, 1.0f, 1.088900371f};  // D65 of the XYZ matrix below

// CIE XYZ divided by the white point, so that white is (1,1,1).
Vec3 xyzFromLinear(const Vec3& rgb) {
  float x = 10135552 / 24577794.0f * rgb[0] + 8788810 / 24577794.0f * rgb[1] + 4435075 / 24577794.0f * rgb[2];
  float y = 2613072 / 12288897.0f * rgb[0] + 8788810 / 12288897.0f * rgb[1] + 887015 / 12288897.0f * rgb[2];
  float z = 1425312 / 73733382.0f * rgb[0] + 8788810 / 73733382.0f * rgb[1] + 70074185.0f / 73733382.0f * rgb[2];
  return {x / kWhite[0], y / kWhite[1], z / kWhite[2]};
}

// Inverse of `xyzFromLinear`, clamped to [0,1].
Vec3 linearFromXyz(const Vec3& relative) {
  float x = relative[0] * kWhite[0], y = relative[1] * kWhite[1], z = relative[2] * kWhite[2];
  auto clamped = [](float v) { return std::min(std::max(v, 0.0f), 1.0f); };
  return {clamped(3.241003275f * x - 1.537398934f * y - 0.498615861f * z),
          clamped(-0.969224334f * x + 1.875930071f * y + 0.041554224f * z),
          clamped(0.055639423f * x - 0.204011202f * y + 1.057148933f * z)};
}

float labCurve(float v) {
  constexpr float delta = 6 / 29.0f;
  return v > delta * delta * delta ? std::cbrt(v) : v / (3 * delta * delta) + 4 / 29.0f;
}

// CIELab with the Hunt effect: the chroma of dark colours is reduced.
Vec3 huntLabFromLinear(const Vec3& rgb) {
  Vec3 xyz = xyzFromLinear(rgb);
  float x = labCurve(xyz[0]), y = labCurve(xyz[1]), z = labCurve(xyz[2]);
  float lightness = 116 * y - 16;
  return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

float hyabDistance(const Vec3& p, const Vec3& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

// ---- filters ------------------------------------------------------------------------------------------------------

// Convolution of each row. Borders repeat the outermost pixel.
Plane alongRows(const Plane& in, const std::vector<float>& taps) {
  int radius = static_cast<int>(taps.size()) / 2;
  Plane out(in.width, in.height);
  std::vector<float> padded(size_t(in.width) + 2 * radius);
  for (int y = 0; y < in.height; ++y) {
    const float* from = in.row(y);
    for (int i = 0; i < int(padded.size()); ++i) padded[i] = from[std::clamp(i - radius, 0, in.width - 1)];
    float* to = out.row(y);
    for (size_t k = 0; k < taps.size(); ++k)
      for (int x = 0; x < in.width; ++x) to[x] += taps[k] * padded[x + k];
  }
  return out;
}

Plane alongColumns(const Plane& in, const std::vector<float>& taps) {
  int radius = static_cast<int>(taps.size()) / 2;
  Plane out(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    float* to = out.row(y);
    for (int k = 0; k < int(taps.size()); ++k) {
      const float* from = in.row(std::clamp(y + k - radius, 0, in.height - 1));
      for (int x = 0; x < in.width; ++x) to[x] += taps[k] * from[x];
    }
  }
  return out;
}

Plane blurred(const Plane& in, const std::vector<float>& taps) { return alongColumns(alongRows(in, taps), taps); }

// Gaussian term a sqrt(pi/b) exp(-pi^2 r^2 / b) of a contrast sensitivity function, r in degrees: normalised taps, and
// the integral over the image, which is the weight of the term in a sum.
struct Sensitivity {
  std::vector<float> taps;
  double integral;
};

Sensitivity sensitivity(double a, double b, double pixels_per_degree) {
  // All filters have the radius of the widest filter: three standard deviations of b = 0.04.
  int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * pixels_per_degree));
  std::vector<double> weights;
  for (int i = -radius; i <= radius; ++i) {
    double degrees = i / pixels_per_degree;
    weights.push_back(std::exp(-kPi * kPi * degrees * degrees / b));
  }
  double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  Sensitivity result{{}, a * std::sqrt(kPi / b) * sum * sum};
  for (double weight : weights) result.taps.push_back(static_cast<float>(weight / sum));
  return result;
}

// Gaussian and its first and second derivatives, with the width of a visible feature. Each lobe of a derivative sums to
// 1 or -1.
struct FeatureTaps {
  std::vector<float> gaussian, edge, point;
};

std::vector<float> normaliseLobes(const std::vector<double>& weights) {
  double positive = 0, negative = 0;
  for (double weight : weights) (weight > 0 ? positive : negative) += std::abs(weight);
  std::vector<float> taps;
  for (double weight : weights) taps.push_back(static_cast<float>(weight / (weight > 0 ? positive : negative)));
  return taps;
}

FeatureTaps featureTaps(double pixels_per_degree) {
  double sigma = 0.5 * 0.082 * pixels_per_degree;
  int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> gaussian, edge, point;
  for (int i = -radius; i <= radius; ++i) {
    double g = std::exp(-i * i / (2 * sigma * sigma));
    gaussian.push_back(g);
    edge.push_back(-i * g);
    point.push_back((i * i / (sigma * sigma) - 1) * g);
  }
  return {normaliseLobes(gaussian), normaliseLobes(edge), normaliseLobes(point)};
}

// ---- an image as perceived ----------------------------------------------------------------------------------------

struct PerceivedImage {
  std::vector<Vec3> colour;  // Hunt-adjusted CIELab after the blur of the eye
  Plane edge, point;         // strength of features
};

Plane lengthOf(const Plane& x, const Plane& y) {
  Plane out(x.width, x.height);
  for (size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
  return out;
}

Plane greyOf(const Plane& luminance) {
  Plane grey = luminance;
  for (float& value : grey.values) value = (value + 16) / 116;
  return grey;
}

// The blue-yellow sensitivity is the sum of two Gaussians.
Plane blurBlueYellow(const Plane& in, double ppd) {
  Sensitivity narrow = sensitivity(34.1, 0.04, ppd), wide = sensitivity(13.5, 0.025, ppd);
  Plane out = blurred(in, narrow.taps), other = blurred(in, wide.taps);
  float share = static_cast<float>(narrow.integral / (narrow.integral + wide.integral));
  for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = share * out.values[i] + (1 - share) * other.values[i];
  return out;
}

std::vector<Vec3> seenColours(const Plane& y, const Plane& cx, const Plane& cz) {
  std::vector<Vec3> colours(y.values.size());
  for (size_t i = 0; i < colours.size(); ++i) {
    float luminance = (y.values[i] + 16) / 116;
    Vec3 xyz = {luminance + cx.values[i] / 500, luminance, luminance - cz.values[i] / 200};
    colours[i] = huntLabFromLinear(linearFromXyz(xyz));
  }
  return colours;
}

// `image`: linear RGB in [0,1], three channels.
PerceivedImage see(const Image& image, double ppd) {
  Plane y(image.width, image.height), cx = y, cz = y;
  for (size_t i = 0; i < y.values.size(); ++i) {
    Vec3 xyz = xyzFromLinear({image.values[3 * i], image.values[3 * i + 1], image.values[3 * i + 2]});
    y.values[i] = 116 * xyz[1] - 16;
    cx.values[i] = 500 * (xyz[0] - xyz[1]);
    cz.values[i] = 200 * (xyz[1] - xyz[2]);
  }
  FeatureTaps taps = featureTaps(ppd);
  Plane grey = greyOf(y);
  Plane smooth_rows = alongRows(grey, taps.gaussian), smooth_columns = alongColumns(grey, taps.gaussian);
  Plane edge = lengthOf(alongRows(smooth_columns, taps.edge), alongColumns(smooth_rows, taps.edge));
  Plane point = lengthOf(alongRows(smooth_columns, taps.point), alongColumns(smooth_rows, taps.point));
  Plane seen_y = blurred(y, sensitivity(1, 0.0047, ppd).taps);
  Plane seen_cx = blurred(cx, sensitivity(1, 0.0053, ppd).taps);
  return {seenColours(seen_y, seen_cx, blurBlueYellow(cz, ppd)), std::move(edge), std::move(point)};
}

// ---- difference of two perceived images ---------------------------------------------------------------------------

constexpr float kColourExponent = 0.7f;

float largestColourError() {
  return std::pow(hyabDistance(huntLabFromLinear({0, 1, 0}), huntLabFromLinear({0, 0, 1})), kColourExponent);
}

// Maps differences up to 0.4 of the largest to [0,0.95], and larger differences to [0.95,1].
float remapColourError(float error, float largest) {
  float knee = 0.4f * largest;
  if (error < knee) return 0.95f / knee * error;
  return 0.95f + (error - knee) / (largest - knee) * 0.05f;
}

Image differenceOf(const PerceivedImage& test, const PerceivedImage& reference) {
  static const float largest = largestColourError();
  Image map(test.edge.width, test.edge.height, 1);
  for (size_t i = 0; i < map.values.size(); ++i) {
    float colour = std::pow(hyabDistance(test.colour[i], reference.colour[i]), kColourExponent);
    float edge = std::abs(test.edge.values[i] - reference.edge.values[i]);
    float point = std::abs(test.point.values[i] - reference.point.values[i]);
    float feature = std::sqrt(std::max(edge, point) * std::sqrt(0.5f));
    map.values[i] = std::pow(remapColourError(colour, largest), 1 - feature);
  }
  return map;
}

// `test` and `reference`: three channels in [0,1]. The two images are filtered in parallel.
Image flipOfDisplayable(const Image& test, const Image& reference, double ppd) {
  auto seen_test = std::async(std::launch::async, [&] { return see(test, ppd); });
  PerceivedImage seen_reference = see(reference, ppd);
  return differenceOf(seen_test.get(), seen_reference);
}

// ---- exposures ----------------------------------------------------------------------------------------------------

// Tone curve: Narkowicz's fit of ACES, (k0 x^2 + k1 x) / (k2 x^2 + k3 x + k4), with its input scaled by 0.6.
constexpr double kAces[] = {0.36 * 2.51, 0.6 * 0.03, 0.36 * 2.43, 0.6 * 0.59, 0.14};

// Input of the curve for the output `level`: the larger root of a quadratic.
double inputFor(double level) {
  double a = kAces[0] - level * kAces[2], b = kAces[1] - level * kAces[3], c = -level * kAces[4];
  double middle = -0.5 * b / a;
  return middle + std::sqrt(middle * middle - c / a);
}

float luminanceOf(const float* rgb) { return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]; }

Image exposed(Image image, double stops) {
  float scale = static_cast<float>(std::exp2(stops));
  for (float& value : image.values) {
    double x = value * scale;
    double bent = x * (kAces[0] * x + kAces[1]) / (x * (kAces[2] * x + kAces[3]) + kAces[4]);
    value = std::min(std::max(static_cast<float>(bent), 0.0f), 1.0f);
  }
  return image;
}

void assertComparable(const Image& test, const Image& reference) {
  STROBE_ASSERT(sameSize(test, reference) && !test.empty(), "{}x{} and {}x{}", test.width, test.height, reference.width,
                reference.height);
}

std::vector<float> luminances(const Image& image) {
  Image rgb = threeChannels(image);
  std::vector<float> values;
  for (size_t i = 0; i < rgb.values.size(); i += 3) values.push_back(luminanceOf(&rgb.values[i]));
  return values;
}

Image clampUnit(Image image) {
  for (float& value : image.values) value = std::min(std::max(value, 0.0f), 1.0f);
  return image;
}

}  // namespace

Image ldrFlip(const Image& test, const Image& reference, double pixels_per_degree) {
  assertComparable(test, reference);
  return flipOfDisplayable(clampUnit(threeChannels(test)), clampUnit(threeChannels(reference)), pixels_per_degree);
}

const char* exposureSourceName(Exposures::Source source) {
  static const char* const names[] = {
      "given", "reference", "reference, smallest positive luminance for its median of 0",
      "test image, because the reference is black", "none, because both images are black"};
  return names[int(source)];
}

Exposures automaticExposures(const Image& test, const Image& reference) {
  Exposures result{0, 0, 2, Exposures::Source::reference};
  std::vector<float> values = luminances(reference);
  auto black = [&] { return *std::max_element(values.begin(), values.end()) <= 0; };
  if (black()) values = luminances(test), result.source = Exposures::Source::test;
  if (black()) return {0, 0, 2, Exposures::Source::none};

  std::sort(values.begin(), values.end());
  double largest = values.back(), median = values[values.size() / 2];
  if (median <= 0) {
    median = *std::upper_bound(values.begin(), values.end(), 0.0f);
    if (result.source == Exposures::Source::reference) result.source = Exposures::Source::positive;
  }
  double target = inputFor(0.85);
  result.start = std::log2(target / largest);
  result.stop = std::log2(target / median);
  result.count = std::max(2, static_cast<int>(std::ceil(result.stop - result.start)));
  return result;
}

HdrFlip hdrFlip(const Image& test, const Image& reference, const std::optional<Exposures>& exposures,
                double pixels_per_degree) {
  assertComparable(test, reference);
  Image x = threeChannels(test), r = threeChannels(reference);
  HdrFlip result;
  result.exposures = exposures ? *exposures : automaticExposures(x, r);
  const Exposures& range = result.exposures;
  STROBE_ASSERT(range.count >= 1 && range.start <= range.stop, "{} to {} in {}", range.start, range.stop, range.count);
  double step = range.count > 1 ? (range.stop - range.start) / (range.count - 1) : 0;
  // Equal exposures need one map.
  int looks = step > 0 ? range.count : 1;
  for (int i = 0; i < looks; ++i) {
    double stops = range.start + i * step;
    Image map = flipOfDisplayable(exposed(x, stops), exposed(r, stops), pixels_per_degree);
    if (i == 0) result.map = map;
    for (size_t p = 0; p < map.values.size(); ++p) result.map.values[p] = std::max(result.map.values[p], map.values[p]);
  }
  return result;
}

}  // namespace strobe::image
