// SPDX-License-Identifier: MIT
#include "lab/arrays.h"

namespace strobe::lab {

// The header ends with a line break and is padded so that the values begin at a multiple of 64 bytes.
static std::string headerOf(const char* type, int height, int width, int channels) {
  constexpr size_t kBefore = 10, kAlign = 64;
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}", type, height, width, channels);
  text.resize((kBefore + text.size() + kAlign) / kAlign * kAlign - kBefore - 1, ' ');
  text += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(text.size() & 0xff) + char(text.size() >> 8) + text;
}

template <class Image>
static std::string textOf(const char* type, const Image& image) {
  std::string text = headerOf(type, image.height, image.width, image.channels);
  text.append(reinterpret_cast<const char*>(image.values.data()), image.values.size() * sizeof image.values[0]);
  return text;
}

std::vector<Path> writeArrays(const Picture& picture, const Path& folder) {
  std::vector<Path> files;
  for (const auto* images : {&picture.frame.outputs, &picture.frame.taps})
    for (const auto& [name, image] : *images) {
      files.push_back(folder / (name + ".npy"));
      const std::string text = image.isUint() ? textOf("<u4", image.uints) : textOf("<f4", image.floats);
      writeFileAtomically(files.back(), text, Flush::no);
    }
  return files;
}

}  // namespace strobe::lab
