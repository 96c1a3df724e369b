// SPDX-License-Identifier: MIT
// Texel formats of the images that passes write, by their names in Lua, plans and records, and the format of buffers. A
// buffer has as many entries as an image of its size has texels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strobe::plan {

// Texel format of an image: its name, number of channels, bytes per texel, and whether texels are unsigned integers.
struct Format {
  std::string name;  // "rgba16f"
  int channels = 0;
  int bytes = 0;      // per texel
  bool uint = false;  // texels are unsigned integers
};

// A buffer of 32-bit unsigned integers in place of an image: a head, then one entry per pixel.
inline constexpr const char* kBufferFormat = "buffer32ui";
// Size of the head, bytes: the three numbers of groups of an indirect dispatch, and the number of entries in use.
inline constexpr uint64_t kBufferHead = 16;
inline bool isBuffer(const std::string& format) { return format == kBufferFormat; }
// True if the texels or entries are unsigned integers.
inline bool isUint(const std::string& format) { return format.ends_with("ui"); }

// Memory of an image or buffer, bytes.
uint64_t bytesOf(const std::string& format, int width, int height);

// Formats of ports, in the order of lists in messages and documentation.
const std::vector<Format>& portFormats();

// The format of that name, also "d32f" (the depth attachment of a raster pass); null for an unknown name.
const Format* findFormat(const std::string& name);

}  // namespace strobe::plan
