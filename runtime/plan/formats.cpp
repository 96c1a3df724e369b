// SPDX-License-Identifier: MIT
#include "plan/formats.h"

#include "plan/named.h"

namespace strobe::plan {

const std::vector<Format>& portFormats() {
  static const std::vector<Format> formats = {
      {"r8_unorm", 1, 1, false}, {"rgba8_unorm", 4, 4, false}, {"r32f", 1, 4, false},      {"rg16f", 2, 4, false},
      {"rg32f", 2, 8, false},    {"rgba16f", 4, 8, false},     {"rgba32f", 4, 16, false},  {"r32ui", 1, 4, true},
      {"rg32ui", 2, 8, true},    {"rgba32ui", 4, 16, true},    {kBufferFormat, 1, 4, true}};
  return formats;
}

const Format* findFormat(const std::string& name) {
  static const Format depth{"d32f", 1, 4, false};
  return name == depth.name ? &depth : find(portFormats(), name);
}

uint64_t bytesOf(const std::string& format, int width, int height) {
  const uint64_t texels = uint64_t(width) * uint64_t(height);
  return texels * uint64_t(findFormat(format)->bytes) + (isBuffer(format) ? kBufferHead : 0);
}

}  // namespace strobe::plan
