// SPDX-License-Identifier: MIT
// Decoding of PNG and JPEG bytes to texels.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace strobe::scene {

// Decoded PNG or JPEG image: width and height in texels, and RGBA values with 8 bits per channel.
struct DecodedImage {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;  // 8 bits per channel, top row first
};

// Width and height of an encoded image, in texels.
struct ImageSize {
  int width = 0, height = 0;
};

// Size in the header of a PNG or JPEG; nothing for other bytes.
std::optional<ImageSize> imageSize(const uint8_t* bytes, size_t size);

// Nothing if the bytes are not an image, are cut short in their header, or state more than 16384 texels per side.
std::optional<DecodedImage> decodeImage(const uint8_t* bytes, size_t size);

}  // namespace strobe::scene
