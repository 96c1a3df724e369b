// SPDX-License-Identifier: MIT
// PNG files of display images (sRGB-encoded values in [0,1], see tone.h). 8 bits are written, any depth is read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "image/image.h"

namespace strobe::image {

// `display` has 1, 3 or 4 channels; values are clamped and rounded to the nearest of 256 levels. The bytes depend on
// nothing but values and effort: fixed settings, no date. 1 channel is written as grey. `fast`: a third of the time,
// half as large again.
enum class PngEffort { usual, fast };
std::string encodePng(const Image& display, PngEffort effort = PngEffort::usual);
void writePng(const Path& file, const Image& display);

// As readPng; `name` is what an error calls the bytes.
Image decodePng(std::string_view bytes, const std::string& name);

// Samples as stored, over the largest of their depth: sRGB unless the chunks of the file say otherwise. 3 channels, or
// 4 when the file has transparency; grey and palettes become RGB.
// Throws `Error` naming the file when it is missing, cut short or not a PNG.
Image readPng(const Path& file);

struct LinearPng {
  Image linear;                    // RGB, Rec. 709
  std::vector<std::string> notes;  // colour that the file states and that is converted, or not used
};

// A PNG is display-referred whatever its depth. The chunks sRGB, gAMA and cHRM are used; without them the values are
// sRGB. cICP and iCCP are used if they say sRGB, and noted otherwise.
LinearPng readLinearPng(const Path& file);

}  // namespace strobe::image
