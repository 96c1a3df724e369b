// SPDX-License-Identifier: MIT
#include "image/false_colour.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "math/constants.h"

namespace strobe::image {
namespace {

// Image with colourAt(i) at every pixel i, in reading order.
template <class ColourAt>
Image painted(int width, int height, ColourAt colourAt) {
  Image display(width, height, 3);
  for (size_t i = 0; i < display.values.size() / 3; ++i) {
    Colour colour = colourAt(i);
    std::copy(colour.begin(), colour.end(), &display.values[3 * i]);
  }
  return display;
}

float unit(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

void assertAlike(const Image& a, const Image& b) {
  STROBE_ASSERT(sameSize(a, b), "{}x{} and {}x{}", a.width, a.height, b.width, b.height);
}

// Channel `c`, 0 to 2, of pixel `i`. The last channel stands in for missing channels.
float colourOf(const Image& image, size_t i, int c) {
  return image.values[i * image.channels + std::min(c, image.channels - 1)];
}

// Colour of full saturation; hue in [0,1).
Colour pureHue(float hue) {
  auto ramp = [](float h) { return unit(std::abs(6 * (h - std::floor(h)) - 3) - 1); };
  return {ramp(hue), ramp(hue + 2 / 3.0f), ramp(hue + 1 / 3.0f)};
}

// Linear interpolation from `from` to `to`.
Colour mix(const Colour& from, const Colour& to, float t) {
  Colour result;
  for (int c = 0; c < 3; ++c) result[c] = from[c] + t * (to[c] - from[c]);
  return result;
}

// Spreads neighbouring ids over all 32 bits (an invertible multiply-xorshift).
uint32_t scatter(uint32_t id) {
  id = (id ^ id >> 16) * 0x7feb352du;
  id = (id ^ id >> 15) * 0x846ca68bu;
  return id ^ id >> 16;
}

}  // namespace

void markNotFinite(Image& display, const Image& data, int channels, bool sky) {
  STROBE_ASSERT(sameSize(display, data) && display.channels == 3, "{} channels", display.channels);
  for (size_t i = 0; i < display.values.size() / 3; ++i) {
    const float* value = &data.values[i * size_t(data.channels)];
    bool nan = false, infinite = false;
    for (int c = 0; c < std::min(channels, data.channels); ++c) {
      nan = nan || std::isnan(value[c]);
      infinite = infinite || (std::isinf(value[c]) && !(sky && value[c] > 0));
    }
    if (nan || infinite) std::copy_n((nan ? kNanColour : kInfiniteColour).begin(), 3, &display.values[3 * i]);
  }
}

Image absoluteDifference(const Image& a, const Image& b, float gain) {
  assertAlike(a, b);
  return painted(a.width, a.height, [&](size_t i) {
    Colour colour;
    for (int c = 0; c < 3; ++c) colour[c] = unit(gain * std::abs(colourOf(a, i, c) - colourOf(b, i, c)));
    return colour;
  });
}

Image differenceHeat(const Image& a, const Image& b, float gain) {
  assertAlike(a, b);
  return painted(a.width, a.height, [&](size_t i) {
    float sum = 0;
    for (int c = 0; c < 3; ++c) sum += std::abs(colourOf(a, i, c) - colourOf(b, i, c));
    return magma(gain * sum / 3);
  });
}

Image heatMap(const Image& scalar, float low, float high) {
  STROBE_ASSERT(high > low, "{} to {}", low, high);
  return painted(scalar.width, scalar.height,
                 [&](size_t i) { return magma((scalar.values[i * scalar.channels] - low) / (high - low)); });
}

Image velocityColours(const Image& velocity, float full_px) {
  STROBE_ASSERT(velocity.channels >= 2 && full_px > 0, "{} channels, {} px", velocity.channels, full_px);
  return painted(velocity.width, velocity.height, [&](size_t i) {
    float x = velocity.values[i * velocity.channels], y = velocity.values[i * velocity.channels + 1];
    float length = std::hypot(x, y) / full_px;
    if (!(length > 0)) return Colour{0, 0, 0};
    Colour hue = pureHue(std::atan2(y, x) / float(2 * kPi));
    if (length <= 1) return mix({0, 0, 0}, hue, length);
    return mix(hue, {1, 1, 1}, 1 - 1 / length);
  });
}

Image idColours(const UintImage& ids) {
  return painted(ids.width, ids.height, [&](size_t i) {
    uint32_t id = ids.values[i * ids.channels];
    if (id == 0) return Colour{0, 0, 0};
    uint32_t bits = scatter(id);
    Colour hue = pureHue((bits & 0xffff) / 65536.0f);
    float paleness = 0.6f * (bits >> 16 & 255) / 255, brightness = 0.55f + 0.45f * (bits >> 24) / 255;
    return mix({0, 0, 0}, mix(hue, {1, 1, 1}, paleness), brightness);
  });
}

Image depthColours(const Image& depth, float near_m, float far_m) {
  // The darkest tenth of magma is reserved for pixels without a depth.
  float span = std::max(std::log(far_m / near_m), 1e-6f);
  return painted(depth.width, depth.height, [&](size_t i) {
    float value = depth.values[i * depth.channels];
    if (!std::isfinite(value) || value <= 0) return Colour{0, 0, 0};
    return magma(1 - 0.9f * unit(std::log(value / near_m) / span));
  });
}

}  // namespace strobe::image
