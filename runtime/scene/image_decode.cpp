// SPDX-License-Identifier: MIT
#include "scene/image_decode.h"

#include <climits>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace strobe::scene {

std::optional<ImageSize> imageSize(const uint8_t* bytes, size_t size) {
  ImageSize image;
  int channels = 0;
  bool is_known = size <= INT_MAX && stbi_info_from_memory(bytes, int(size), &image.width, &image.height, &channels);
  return is_known ? std::optional(image) : std::nullopt;
}

std::optional<DecodedImage> decodeImage(const uint8_t* bytes, size_t size) {
  if (size > INT_MAX) return std::nullopt;
  DecodedImage image;
  int channels = 0;
  uint8_t* texels = stbi_load_from_memory(bytes, int(size), &image.width, &image.height, &channels, 4);
  if (!texels) return std::nullopt;
  image.rgba.assign(texels, texels + size_t(image.width) * image.height * 4);
  stbi_image_free(texels);
  return image;
}

}  // namespace strobe::scene
