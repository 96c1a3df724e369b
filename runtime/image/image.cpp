// SPDX-License-Identifier: MIT
#include "image/image.h"

#include <algorithm>

namespace strobe::image {

bool sameSize(const Image& a, const Image& b) { return a.width == b.width && a.height == b.height; }

Image threeChannels(const Image& image) {
  if (image.channels == 3) return image;
  Image rgb(image.width, image.height, 3);
  for (size_t i = 0; i < rgb.values.size(); ++i)
    rgb.values[i] = image.values[i / 3 * image.channels + std::min(i % 3, size_t(image.channels) - 1)];
  return rgb;
}

}  // namespace strobe::image
