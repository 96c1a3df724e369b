// SPDX-License-Identifier: MIT
#include "image/jpeg.h"

#include "base/error.h"
#include "image/tone.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace strobe::image {

std::string encodeJpeg(const Image& display, int quality) {
  STROBE_ASSERT(display.channels == 1 || display.channels == 3, "{} channels", display.channels);
  const std::string bytes = levelsOf(display);
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
