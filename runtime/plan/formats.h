// SPDX-License-Identifier: MIT
// The texel formats a pass may write, by the name used in Lua, in plans and in records; and buffers, which have no
// texels but as many entries as an image of their size would have.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strobe::plan {

struct Format {
  std::string name;  // "rgba16f"
  int channels = 0;
  int bytes = 0;      // of one texel
  bool uint = false;  // unsigned integers, sampled as such
};

// A buffer of 32-bit unsigned integers in the place of an image: a head, then an entry for each pixel.
inline constexpr const char* kBufferFormat = "buffer32ui";
// The head: three numbers of groups, as an indirect dispatch has them, and the number of entries in use; bytes.
inline constexpr uint64_t kBufferHead = 16;
inline bool isBuffer(const std::string& format) { return format == kBufferFormat; }
// Of texels, or entries, that are unsigned integers?
inline bool isUint(const std::string& format) { return format.ends_with("ui"); }

// What it takes in memory.
uint64_t bytesOf(const std::string& format, int width, int height);

// Formats a port may have, in the order in which they are listed to people.
const std::vector<Format>& portFormats();

// The format of that name, also "d32f" (the depth attachment of a raster pass); nullptr when there is none.
const Format* findFormat(const std::string& name);

}  // namespace strobe::plan
