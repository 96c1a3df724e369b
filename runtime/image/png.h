// SPDX-License-Identifier: MIT
// PNG and JPEG files of display images (sRGB-encoded values in [0,1], see tone.h). PNG: 8 bits are written; any depth
// is read. JPEG is only written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "image/image.h"

namespace strobe::image {

// Effort of the compression of a PNG file. `fast` takes a third of the time and 1.5 times the bytes.
enum class PngEffort { usual, fast };

// `display` has 1 (written as grey), 3 or 4 channels. Values are clamped and rounded to the nearest of 256 levels.
// Equal values and effort give equal bytes: fixed settings, no date.
std::string encodePng(const Image& display, PngEffort effort = PngEffort::usual);
void writePng(const Path& file, const Image& display);

// Like readPng; `name` stands for the bytes in errors.
Image decodePng(std::string_view bytes, const std::string& name);

// Stored samples, divided by the largest value of their bit depth. Values are sRGB unless chunks of the file state
// otherwise. 3 channels, or 4 if the file has transparency; grey and palettes become RGB. Throws `Error` naming the
// file if it is missing, cut short or not a PNG.
Image readPng(const Path& file);

// PNG image decoded to linear colour, with notes on the colour space that the file states.
struct LinearPng {
  Image linear;                    // RGB, Rec. 709
  std::vector<std::string> notes;  // stated colour that is converted or not used
};

// Reads a PNG as display-referred, at any bit depth. The chunks sRGB, gAMA and cHRM are used; without these chunks the
// values are sRGB. cICP and iCCP are used if they state sRGB, and noted otherwise.
LinearPng readLinearPng(const Path& file);

// JPEG file for pages that would be too large with PNG: small and lossy. `display` has 1 or 3 channels; values are
// clamped. `quality` is 1 to 100. Equal arguments give equal bytes.
std::string encodeJpeg(const Image& display, int quality);

}  // namespace strobe::image
