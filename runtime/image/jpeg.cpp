// SPDX-License-Identifier: MIT
#include "image/jpeg.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace strobe::image {

std::string encodeJpeg(const Image& display, int quality) {
  STROBE_ASSERT(display.channels == 1 || display.channels == 3, "{} channels", display.channels);
  std::vector<uint8_t> bytes(display.values.size());
  std::transform(display.values.begin(), display.values.end(), bytes.begin(),
                 [](float value) { return uint8_t(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); });
  std::string file;
  auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size_t(size));
  };
  int written =
      stbi_write_jpg_to_func(append, &file, display.width, display.height, display.channels, bytes.data(), quality);
  STROBE_ASSERT(written, "{}x{}", display.width, display.height);
  return file;
}

}  // namespace strobe::image
