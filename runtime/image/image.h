// SPDX-License-Identifier: MIT
// Images on the CPU: outputs of passes that are read back, operands of metrics, contents of files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strobe::image {

// width x height pixels, top row first, `channels` interleaved values per pixel. Colour is linear and scene-referred
// unless a function states otherwise.
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

// The image without alpha. If channels are missing, the last channel is repeated.
Image threeChannels(const Image& image);

// Image of integers (instance, geometry and primitive ids).
struct UintImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<uint32_t> values;

  uint32_t at(int x, int y, int c) const { return values[(size_t(y) * width + x) * channels + c]; }
};

}  // namespace strobe::image
