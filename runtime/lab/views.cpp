// SPDX-License-Identifier: MIT
#include "lab/views.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "image/canvas.h"
#include "image/false_colour.h"
#include "image/tone.h"

namespace strobe::lab {

using graph::ReadImage;
using image::Colour;
using image::Image;
using image::Legend;

namespace {

constexpr Colour kTint = {1.0f, 0.50f, 0.08f};

// Name of a port, without its node.
std::string nameOf(const std::string& port) { return port.substr(port.rfind('.') + 1); }

bool has(const std::string& name, const char* part) { return name.find(part) != std::string::npos; }

// Smallest and largest finite value of an image.
struct ValueRange {
  float low = INFINITY, high = -INFINITY;
};

template <class ValueAt>
ValueRange rangeOf(const Image& image, ValueAt valueAt) {
  ValueRange range;
  for (size_t i = 0; i < image.values.size() / size_t(image.channels); ++i) {
    float value = valueAt(&image.values[i * size_t(image.channels)]);
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value), range.high = std::max(range.high, value);
  }
  return range;
}

// Texel for each pixel of the frame, along one axis; -1 outside an image of fixed size.
std::vector<int> texelsAlong(int texels, int divide, int pixels, double scale) {
  std::vector<int> at(size_t(pixels), -1);
  int offset = divide > 0 ? 0 : int((pixels - texels * scale) / 2);
  for (int i = 0; i < pixels; ++i) {
    int texel = divide > 0 ? std::min(i / divide, texels - 1) : int(std::floor((i - offset) / scale));
    at[size_t(i)] = texel >= 0 && texel < texels ? texel : -1;
  }
  return at;
}

// Image scaled to the frame, by nearest texel.
Image placed(const Image& image, int divide, int width, int height) {
  if (image.width == width && image.height == height && divide <= 1) return image;
  double fit = std::min(double(width) / image.width, double(height) / image.height);
  double scale = fit >= 1 ? std::floor(fit) : fit;
  std::vector<int> xs = texelsAlong(image.width, divide, width, scale);
  std::vector<int> ys = texelsAlong(image.height, divide, height, scale);
  Image result(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (xs[size_t(x)] >= 0 && ys[size_t(y)] >= 0)
        std::copy_n(image.pixel(xs[size_t(x)], ys[size_t(y)]), image.channels, result.pixel(x, y));
  return result;
}

// RGB of an image with any number of channels. `sum`: the image is a sum of samples, divided by alpha, the number of
// samples.
Image threeChannels(const Image& image, bool sum) {
  Image rgb(image.width, image.height, 3);
  for (size_t i = 0; i < rgb.values.size() / 3; ++i) {
    const float* from = &image.values[i * size_t(image.channels)];
    float scale = sum && image.channels == 4 && from[3] > 0 ? 1 / from[3] : 1;
    for (int c = 0; c < 3; ++c) rgb.values[3 * i + size_t(c)] = scale * from[std::min(c, image.channels - 1)];
  }
  return rgb;
}

// sRGB encoding by table, 4096 entries per unit of the square root. The rounding error is far below one of 256 levels.
float encodeFast(float linear) {
  static const std::vector<float> table = [] {
    std::vector<float> made(4097);
    for (size_t i = 0; i < made.size(); ++i) made[i] = image::encodeSrgb(float(i * i) / (4096.0f * 4096.0f));
    return made;
  }();
  return table[size_t(linear > 0 ? std::lround(4096 * std::sqrt(std::min(linear, 1.0f))) : 0)];
}

Image colourView(const Image& image, bool sum, double stops) {
  Image display = threeChannels(image, sum);
  float scale = float(std::exp2(stops));
  for (float& value : display.values) value = encodeFast(value * scale);
  image::markNotFinite(display, image);
  return display;
}

Image normalView(const Image& image) {
  Image display(image.width, image.height, 3);
  for (size_t i = 0; i < display.values.size() / 3; ++i) {
    const float* n = &image.values[i * size_t(image.channels)];
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
    for (int c = 0; c < 3; ++c) display.values[3 * i + size_t(c)] = std::clamp(n[c] * 0.5f + 0.5f, 0.0f, 1.0f);
  }
  image::markNotFinite(display, image);
  return display;
}

// Full scale of displacements, px: `wanted`, or a round length that 99.5 % of the displacements do not exceed, so that
// few outliers do not darken the rest.
double fullLength(const Image& image, double wanted) {
  if (wanted > 0) return wanted;
  std::vector<float> lengths;
  for (size_t i = 0; i < image.values.size(); i += size_t(image.channels)) {
    float length = std::hypot(image.values[i], image.values[i + 1]);
    if (std::isfinite(length) && length > 1e-3f) lengths.push_back(length);
  }
  if (lengths.empty()) return 1;
  auto chosen = lengths.begin() + ptrdiff_t((lengths.size() - 1) * 199 / 200);
  std::nth_element(lengths.begin(), chosen, lengths.end());
  return image::niceCeiling(*chosen);
}

// Scalar of a texel: length for two channels, mean for three.
float scalarOf(const float* texel, int channels) {
  if (channels == 1) return texel[0];
  return channels == 2 ? std::hypot(texel[0], texel[1]) : (texel[0] + texel[1] + texel[2]) / 3;
}

ValueRange scaleOf(ValueRange found, const ViewOptions& options) {
  if (options.high > options.low) return {float(options.low), float(options.high)};
  if (!(found.high >= found.low)) return {0, 1};
  float widened = std::max(std::abs(found.high) * 1e-3f, 1e-6f);
  return found.high > found.low ? found : ValueRange{found.low, found.low + widened};
}

Image scalarView(const Image& image, ValueRange range) {
  Image values(image.width, image.height, 1);
  for (size_t i = 0; i < values.values.size(); ++i)
    values.values[i] = scalarOf(&image.values[i * size_t(image.channels)], image.channels);
  Image display = image::heatMap(values, range.low, range.high);
  image::markNotFinite(display, image);
  return display;
}

ValueRange depthScale(const Image& image, const ViewOptions& options) {
  if (options.high > options.low && options.low > 0) return {float(options.low), float(options.high)};
  ValueRange found = rangeOf(image, [](const float* depth) { return *depth > 0 ? *depth : INFINITY; });
  return found.high > 0 ? found : ValueRange{1, 2};
}

Image depthView(const Image& image, ValueRange range) {
  float far_m = std::max(range.high, range.low * 1.0001f);
  Image display = image::depthColours(image, range.low, far_m);
  image::markNotFinite(display, image, 1, true);
  return display;
}

float luminance(const Colour& c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

// Colour beneath a mask or arrows, display-encoded; black without a colour.
Image beneath(const Image* under, int width, int height, const ViewOptions& options) {
  if (!under || !options.over) return Image(width, height, 3);
  return placed(colourView(*under, false, options.exposure_stops), 1, width, height);
}

// Dimmed, desaturated picture. Masked pixels are orange and keep the luminance contrast of the picture.
Image maskView(const Image& mask, Image display, bool over) {
  for (size_t i = 0; i < display.values.size() / 3; ++i) {
    float* pixel = &display.values[3 * i];
    float raw = mask.values[i * size_t(mask.channels)], m = raw > 0 ? std::min(raw, 1.0f) : 0.0f;
    float light = luminance({pixel[0], pixel[1], pixel[2]});
    for (size_t c = 0; c < 3; ++c) {
      float dim = 0.45f * (0.6f * light + 0.4f * pixel[c]);
      float tint = kTint[c] * (0.55f + 0.45f * light);
      pixel[c] = over ? dim + m * (tint - dim) : m;
    }
  }
  image::markNotFinite(display, mask, 1);
  return display;
}

// Scale of the arrows: 1 if their true length is readable, otherwise a power of two.
double arrowScale(double longest_px, double step) {
  double scale = 1;
  while (longest_px * scale > 3 * step) scale /= 2;
  while (longest_px * scale * 2 <= step && scale < 1024) scale *= 2;
  return scale;
}

Colour hueOf(vec2 unit) {
  Image vector(1, 1, 2);
  vector.values = {unit.x, unit.y};
  Image colour = image::velocityColours(vector, 1);
  return {colour.values[0], colour.values[1], colour.values[2]};
}

std::string scaleText(double scale) {
  if (scale == 1) return "arrows: displacement, true length";
  return fmt::format("arrows: displacement × {}{:g}", scale < 1 ? "1/" : "", scale < 1 ? 1 / scale : scale);
}

Image arrowView(const Image& vectors, Image display, const ViewOptions& options, Legend& legend) {
  for (float& value : display.values) value *= 0.55f;
  image::Canvas canvas(display);
  double full = fullLength(vectors, options.high);
  double fine = std::clamp(display.width / 40, 10, 40), scale = arrowScale(full, fine);
  // Grid wide enough that an arrow ends before the next begins. Rows are staggered, so that the grid also hits thin
  // objects.
  int step = int(std::clamp(1.15 * full * scale, 1.4 * fine, 2 * fine)), pitch = step / 2, row = 0;
  for (int y = pitch / 2; y < display.height; y += pitch, ++row)
    for (int x = row % 2 ? step : step / 2; x < display.width; x += step) {
      vec2 v(vectors.at(x, y, 0), vectors.at(x, y, 1));
      float length = glm::length(v);
      if (!std::isfinite(length) || length * scale < 1) continue;
      dvec2 from(x + 0.5, y + 0.5), to = from + dvec2(v) * std::min(scale, 4096.0 / length);
      canvas.arrow(from, to, std::max(1.5, fine / 12), hueOf(v / length));
    }
  display = canvas.pixels();
  image::markNotFinite(display, vectors, 2);
  legend = {Legend::Kind::words, 0, 0, scaleText(scale)};
  return display;
}

std::string middleOf(int channels) { return channels == 1 ? "" : channels == 2 ? "length" : "mean of channels"; }

Image floatsShown(const Image& data, const std::string& kind, const std::string& name, int divide, int width,
                  int height, const ViewOptions& options, const Image* under, Legend& legend) {
  if (kind == "mask")
    return maskView(placed(data, divide, width, height), beneath(under, width, height, options), options.over);
  if (kind == "arrows")
    return arrowView(placed(data, divide, width, height), beneath(under, width, height, options), options, legend);
  if (kind == "normal") return placed(normalView(data), divide, width, height);
  if (kind == "velocity") {
    double full = fullLength(data, options.high);
    Image display = image::velocityColours(data, float(full));
    image::markNotFinite(display, data, 2);
    legend = {Legend::Kind::wheel, 0, full, ""};
    return placed(display, divide, width, height);
  }
  if (kind == "depth") {
    ValueRange range = depthScale(data, options);
    legend = {Legend::Kind::depth, range.low, range.high, ""};
    return placed(depthView(data, range), divide, width, height);
  }
  if (kind == "scalar") {
    ValueRange range = scaleOf(rangeOf(data, [&](const float* t) { return scalarOf(t, data.channels); }), options);
    legend = {Legend::Kind::bar, range.low, range.high, middleOf(data.channels)};
    return placed(scalarView(data, range), divide, width, height);
  }
  return placed(colourView(data, name.starts_with("sum"), options.exposure_stops), divide, width, height);
}

}  // namespace

std::string automaticKind(const ReadImage& image, const std::string& port) {
  std::string name = nameOf(port);
  if (image.isUint()) return "id";
  int channels = image.channels();
  if (channels == 1 && (has(name, "depth") || name == "Z")) return "depth";
  if (channels == 1) return image.format == "r8_unorm" ? "mask" : "scalar";
  if (channels == 2) return "velocity";
  if (has(name, "normal")) return "normal";
  return has(name, "motion") || has(name, "velocity") ? "velocity" : "colour";
}

std::vector<std::string> viewKinds(const ReadImage& image) {
  if (image.isUint()) return {"auto", "id", "numbers"};
  int channels = image.channels();
  if (channels == 1) return {"auto", "scalar", "mask", "depth", "colour", "numbers"};
  if (channels == 2) return {"auto", "velocity", "arrows", "scalar", "numbers"};
  return {"auto", "colour", "normal", "velocity", "arrows", "scalar", "numbers"};
}

int divideOf(const plan::Plan& plan, const std::string& port) {
  for (const auto* images : {&plan.outputs, &plan.taps})
    for (const auto& [name, image] : *images)
      if (name == port) return plan.images[size_t(image)].divide;
  int image = plan::findImage(plan, port);
  return image < 0 ? 1 : plan.images[size_t(image)].divide;
}

Image shown(const ReadImage& image, const std::string& port, int divide, int width, int height,
            const ViewOptions& options, const Image* under, Legend* legend) {
  if (legend) *legend = {};
  if (image.isUint()) return placed(image::idColours(image.uints), divide, width, height);
  if (image.floats.empty()) return Image(width, height, 3);
  bool automatic = !contains(viewKinds(image), options.kind) || options.kind == "auto" || options.kind == "numbers";
  std::string kind = automatic ? automaticKind(image, port) : options.kind;
  Legend made;
  Image display = floatsShown(image.floats, kind, nameOf(port), divide, width, height, options, under, made);
  if (legend) *legend = made;
  else image::drawLegend(display, made);
  return display;
}

int wipedFrom(double at, int width) { return int(std::lround(std::clamp(at, 0.0, 1.0) * width)); }

Image wiped(const Image& a, const Image& b, double at) {
  STROBE_ASSERT(a.width == b.width && a.height == b.height && a.channels == 3 && b.channels == 3,
                "{}x{}x{} and {}x{}x{}", a.width, a.height, a.channels, b.width, b.height, b.channels);
  Image result = a;
  int split = wipedFrom(at, a.width);
  for (int y = 0; y < a.height; ++y)
    for (int x = split; x < a.width; ++x) std::copy_n(b.pixel(x, y), 3, result.pixel(x, y));
  if (split == 0 || split == a.width) return result;
  int line = std::max(1, a.width / 640);
  image::fill(result, {split - line, 0, 2 * line, a.height}, {0, 0, 0});
  image::fill(result, {split - (line + 1) / 2, 0, std::max(1, line), a.height}, {1, 1, 1});
  return result;
}

Image difference(const Image& linear_a, const Image& linear_b, double gain, const std::string& title, Legend* legend) {
  STROBE_ASSERT(gain > 0, "{}", gain);
  Image display = image::differenceHeat(linear_a, linear_b, float(gain));
  image::markNotFinite(display, linear_a);
  image::markNotFinite(display, linear_b);
  Legend made{Legend::Kind::bar, 0, 1 / gain, title};
  if (legend) *legend = made;
  else image::drawLegend(display, made);
  return display;
}

}  // namespace strobe::lab
