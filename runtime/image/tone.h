// SPDX-License-Identifier: MIT
// Conversion between linear, scene-referred colour and display images: sRGB-encoded values in [0,1].
#pragma once

#include "image/image.h"

namespace strobe::image {

// The sRGB transfer function (IEC 61966-2-1). Values outside [0,1] are clamped first; NaN becomes 0.
float encodeSrgb(float linear);
float decodeSrgb(float encoded);

// Level of a display value in a file of 8 bits, clamped; NaN becomes 0. Levels of all values of a display image.
uint8_t levelOf(float display);
std::string levelsOf(const Image& display);

// Conversion of the colour channels of an image; a fourth channel is alpha and is only clamped. `encodeSrgb` is the
// transform for PSNR and SSIM: clamp to [0,1], then encode.
Image encodeSrgb(const Image& linear);
Image decodeSrgb(const Image& display);

// Tone mapping of a linear image: multiply by 2^stops, apply the curve, clamp, encode as sRGB.
struct ToneMap {
  enum class Curve {
    clamp,   // no curve, as in metrics
    filmic,  // Narkowicz's rational fit of the ACES curve, input scaled by 0.6: compresses highlights; for viewing only
  };
  float stops = 0;
  Curve curve = Curve::clamp;
};
Image toneMap(const Image& linear, const ToneMap& tone = {});

}  // namespace strobe::image
