// SPDX-License-Identifier: MIT
// CPU images: what passes' outputs become when they are read back, what metrics compare and files hold.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strobe::image {

// width x height pixels, top row first, `channels` interleaved values per pixel. Colour is linear and scene-referred
// unless the function that takes it says otherwise.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;

  Image() = default;
  Image(int w, int h, int c, float fill = 0) : width(w), height(h), channels(c), values(size_t(w) * h * c, fill) {}
  float* pixel(int x, int y) { return &values[(size_t(y) * width + x) * channels]; }
  const float* pixel(int x, int y) const { return &values[(size_t(y) * width + x) * channels]; }
  float& at(int x, int y, int c) { return pixel(x, y)[c]; }
  float at(int x, int y, int c) const { return pixel(x, y)[c]; }
  bool empty() const { return values.empty(); }
};

bool sameSize(const Image& a, const Image& b);

// Without alpha; the last of fewer channels stands for those that are missing.
Image threeChannels(const Image& image);

// The same for integers (instance, geometry and primitive ids).
struct UintImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<uint32_t> values;

  uint32_t at(int x, int y, int c) const { return values[(size_t(y) * width + x) * channels + c]; }
};

}  // namespace strobe::image
