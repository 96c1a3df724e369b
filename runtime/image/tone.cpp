// SPDX-License-Identifier: MIT
#include "image/tone.h"

#include <algorithm>
#include <cmath>

namespace strobe::image {

// NaN fails the first comparison and becomes 0.
static float clampUnit(float value) { return value > 0 ? (value < 1 ? value : 1.0f) : 0.0f; }

float encodeSrgb(float linear) {
  float v = clampUnit(linear);
  return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

float decodeSrgb(float encoded) {
  float v = clampUnit(encoded);
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

uint8_t levelOf(float display) { return uint8_t(clampUnit(display) * 255 + 0.5f); }

std::string levelsOf(const Image& display) {
  std::string levels(display.values.size(), '\0');
  std::transform(display.values.begin(), display.values.end(), levels.begin(), levelOf);
  return levels;
}

template <class Transform>
static Image mapColours(const Image& from, Transform transform) {
  Image to = from;
  for (size_t i = 0; i < to.values.size(); ++i) {
    bool alpha = from.channels == 4 && i % 4 == 3;
    to.values[i] = alpha ? clampUnit(from.values[i]) : transform(from.values[i]);
  }
  return to;
}

Image encodeSrgb(const Image& linear) {
  return mapColours(linear, [](float v) { return encodeSrgb(v); });
}

Image decodeSrgb(const Image& display) {
  return mapColours(display, [](float v) { return decodeSrgb(v); });
}

static float filmic(float v) {
  float x = 0.6f * std::fmax(v, 0.0f);
  if (std::isinf(x)) return 1;
  return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
}

Image toneMap(const Image& linear, const ToneMap& tone) {
  float scale = std::exp2(tone.stops);
  if (tone.curve == ToneMap::Curve::clamp) return mapColours(linear, [=](float v) { return encodeSrgb(v * scale); });
  return mapColours(linear, [=](float v) { return encodeSrgb(filmic(v * scale)); });
}

}  // namespace strobe::image
