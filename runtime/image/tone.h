// SPDX-License-Identifier: MIT
// Between linear, scene-referred colour and what a display shows: sRGB-encoded values in [0,1] ("display" images).
#pragma once

#include "image/image.h"

namespace strobe::image {

// The sRGB transfer function (IEC 61966-2-1). Values outside [0,1] are clamped first; NaN becomes 0.
float encodeSrgb(float linear);
float decodeSrgb(float encoded);

// The same for the colour channels of an image; a fourth channel is alpha and is only clamped.
// `encodeSrgb` is the transform on which PSNR and SSIM are measured: clamp to [0,1], then encode.
Image encodeSrgb(const Image& linear);
Image decodeSrgb(const Image& display);

// How a linear image is made visible: multiplied by 2^stops, bent by the curve, clamped, sRGB-encoded.
struct ToneMap {
  enum class Curve {
    clamp,   // none: what metrics see
    filmic,  // Narkowicz's rational fit of the ACES curve, input scaled by 0.6: rolls highlights off, for looking only
  };
  float stops = 0;
  Curve curve = Curve::clamp;
};
Image toneMap(const Image& linear, const ToneMap& tone = {});

}  // namespace strobe::image
