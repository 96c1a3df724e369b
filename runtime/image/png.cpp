// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <png.h>

#include <cmath>
#include <vector>

#include "base/error.h"

namespace strobe::image {

static png_uint_32 formatFor(int channels) {
  if (channels == 1) return PNG_FORMAT_GRAY;
  return channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
}

static std::vector<png_byte> quantise(const Image& display) {
  std::vector<png_byte> bytes(display.values.size());
  for (size_t i = 0; i < bytes.size(); ++i) {
    float v = display.values[i];
    bytes[i] = v > 0 ? static_cast<png_byte>(std::fmin(v, 1.0f) * 255 + 0.5f) : 0;
  }
  return bytes;
}

std::string encodePng(const Image& display, PngEffort effort) {
  STROBE_ASSERT(display.width > 0 && display.height > 0, "{}x{}", display.width, display.height);
  STROBE_ASSERT(display.channels == 1 || display.channels == 3 || display.channels == 4, "{}", display.channels);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(display.width);
  png.height = static_cast<png_uint_32>(display.height);
  png.format = formatFor(display.channels);
  if (effort == PngEffort::fast) png.flags |= PNG_IMAGE_FLAG_FAST;
  std::vector<png_byte> pixels = quantise(display);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  int written = png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  STROBE_ASSERT(written, "{}", png.message);
  bytes.resize(size);
  return bytes;
}

void writePng(const Path& file, const Image& display) { writeFileAtomically(file, encodePng(display)); }

Image decodePng(std::string_view bytes, const std::string& name) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  auto refuse = [&](const char* why) {
    std::string message = fmt::format("is not a readable PNG: {}", why);
    png_image_free(&png);
    throw Error(message, {name});
  };
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) refuse(png.message);
  if (png.width > 65536 || png.height > 65536) refuse("larger than 65536 pixels");
  png.format = png.format & PNG_FORMAT_FLAG_ALPHA ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr)) refuse(png.message);

  Image display(static_cast<int>(png.width), static_cast<int>(png.height), PNG_IMAGE_SAMPLE_CHANNELS(png.format));
  for (size_t i = 0; i < pixels.size(); ++i) display.values[i] = pixels[i] / 255.0f;
  return display;
}

Image readPng(const Path& file) { return decodePng(readText(file), file.string()); }

}  // namespace strobe::image
