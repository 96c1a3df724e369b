// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "image/primaries.h"
#include "image/tone.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace strobe::image {

static png_uint_32 formatFor(int channels) {
  if (channels == 1) return PNG_FORMAT_GRAY;
  return channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
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
  const std::string pixels = levelsOf(display);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  int written = png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  STROBE_ASSERT(written, "{}", png.message);
  bytes.resize(size);
  return bytes;
}

void writePng(const Path& file, const Image& display) { writeFileAtomically(file, encodePng(display)); }

namespace {

// Samples of a file, and the colour that its chunks state.
struct DecodedPng {
  uint32_t width = 0, height = 0;
  int channels = 0, bytes_per_sample = 1;
  std::vector<png_byte> samples;  // 16 bits: the high byte first
  bool says_srgb = false;
  double gamma = 0;  // gAMA; 0: absent
  bool has_primaries = false;
  Primaries primaries;  // cHRM
  std::string icc_profile;
  std::vector<int> code_points;  // cICP: primaries, transfer, matrix, full range
  std::vector<std::string> warnings;
  std::string why;  // reason of the refusal; "": not refused
};

void refuse(png_structp png, png_const_charp why) {
  static_cast<DecodedPng*>(png_get_error_ptr(png))->why = why;
  png_longjmp(png, 1);
}

void keepWarning(png_structp png, png_const_charp warning) {
  static_cast<DecodedPng*>(png_get_error_ptr(png))->warnings.emplace_back(warning);
}

void takeBytes(png_structp png, png_bytep into, size_t count) {
  auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
  if (rest->size() < count) png_error(png, "it is cut short");
  std::memcpy(into, rest->data(), count);
  rest->remove_prefix(count);
}

// A header may state any size, so the size is checked before memory is allocated. Deflate shrinks by a factor of 1032
// at most.
void takeSize(png_structp png, png_infop info, size_t file_bytes, DecodedPng& into) {
  into.width = png_get_image_width(png, info), into.height = png_get_image_height(png, info);
  if (into.width > 65536 || into.height > 65536) png_error(png, "its width or height is above 65536 pixels");
  uint64_t packed = uint64_t(into.width) * into.height * png_get_bit_depth(png, info) * png_get_channels(png, info) / 8;
  if (packed / 1032 > file_bytes) png_error(png, "its size is too large for the bytes of the file");
}

void takeColour(png_structp png, png_infop info, DecodedPng& into) {
  into.says_srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
  if (png_get_valid(png, info, PNG_INFO_gAMA)) png_get_gAMA(png, info, &into.gamma);
  Primaries& p = into.primaries;
  into.has_primaries = png_get_cHRM(png, info, &p.white.x, &p.white.y, &p.red.x, &p.red.y, &p.green.x, &p.green.y,
                                    &p.blue.x, &p.blue.y) != 0;
  png_charp profile = nullptr;
  png_bytep bytes = nullptr;
  png_uint_32 length = 0;
  int compression = 0;
  if (png_get_iCCP(png, info, &profile, &compression, &bytes, &length)) into.icc_profile = profile;
  png_unknown_chunkp unknown = nullptr;
  for (int i = 0, count = png_get_unknown_chunks(png, info, &unknown); i < count; ++i)
    into.code_points.assign(unknown[i].data, unknown[i].data + unknown[i].size);
}

// False if the file is refused, with the reason in `into.why`. Objects with a destructor must be in `into`, since
// libpng leaves by longjmp.
bool decode(png_structp png, png_infop info, size_t file_bytes, DecodedPng& into) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, reinterpret_cast<png_const_bytep>("cICP"), 1);
  png_read_info(png, info);
  takeSize(png, info, file_bytes, into);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  into.channels = png_get_channels(png, info);
  into.bytes_per_sample = png_get_bit_depth(png, info) / 8;
  size_t row = png_get_rowbytes(png, info);
  into.samples.resize(row * into.height);
  for (int pass = 0; pass < passes; ++pass)
    for (uint32_t y = 0; y < into.height; ++y) png_read_row(png, &into.samples[row * y], nullptr);
  png_read_end(png, info);
  takeColour(png, info, into);
  return true;
}

DecodedPng decodedFrom(std::string_view bytes, const std::string& name) {
  DecodedPng decoded;
  std::string_view rest = bytes;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoded, refuse, keepWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  STROBE_ASSERT(info, "libpng {} is not {}", png_get_libpng_ver(nullptr), PNG_LIBPNG_VER_STRING);
  png_set_read_fn(png, &rest, takeBytes);
  bool whole = decode(png, info, bytes.size(), decoded);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!whole) throw Error(fmt::format("is not a readable PNG: {}", decoded.why), {name});
  return decoded;
}

Image storedImage(const DecodedPng& decoded) {
  Image stored(int(decoded.width), int(decoded.height), decoded.channels);
  const png_byte* sample = decoded.samples.data();
  for (float& value : stored.values) {
    value = decoded.bytes_per_sample == 2 ? float(sample[0] * 256 + sample[1]) / 65535 : sample[0] / 255.0f;
    sample += decoded.bytes_per_sample;
  }
  return stored;
}

// True for sRGB values. Their gAMA is 1/2.2, for programs without support for the chunk sRGB.
bool isSrgb(const DecodedPng& decoded) {
  return decoded.says_srgb || decoded.gamma == 0 || std::abs(decoded.gamma - 1 / 2.2) < 5e-4;
}

std::vector<std::string> unusedColour(const DecodedPng& decoded) {
  std::vector<std::string> notes = decoded.warnings;
  const std::vector<int> kSrgbCodePoints = {1, 13, 0, 1};
  if (!decoded.code_points.empty() && decoded.code_points != kSrgbCodePoints)
    notes.push_back(fmt::format("its cICP chunk ({}) is not used: only sRGB (1 13 0 1) is supported",
                                fmt::join(decoded.code_points, " ")));
  if (!decoded.icc_profile.empty() && !decoded.says_srgb)
    notes.push_back(fmt::format("its ICC profile '{}' is not used", decoded.icc_profile));
  return notes;
}

}  // namespace

Image decodePng(std::string_view bytes, const std::string& name) { return storedImage(decodedFrom(bytes, name)); }

Image readPng(const Path& file) { return decodePng(readText(file), file.string()); }

LinearPng readLinearPng(const Path& file) {
  DecodedPng decoded = decodedFrom(readText(file), file.string());
  LinearPng read{threeChannels(storedImage(decoded)), unusedColour(decoded)};
  if (isSrgb(decoded)) {
    read.linear = decodeSrgb(read.linear);
  } else {
    for (float& value : read.linear.values) value = float(std::pow(value, 1 / decoded.gamma));
    read.notes.push_back(fmt::format("its values are decoded with its gamma of {:.5g}, not as sRGB", decoded.gamma));
  }
  bool converts = decoded.has_primaries && !decoded.says_srgb && !decoded.primaries.areRec709();
  if (converts) read.notes.push_back(convertStated(read.linear, decoded.primaries));
  return read;
}

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
