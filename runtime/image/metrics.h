// SPDX-License-Identifier: MIT
// Error of a test image x against its reference r: linear colour of the same size. Means run over the selected pixels
// and over the colour channels; a fourth channel, alpha, is never compared. `mask` selects the pixels with a first
// channel of at least 0.5; further channels are ignored. An empty mask selects all pixels. Every mean is NaN if no
// pixel is selected.
#pragma once

#include <optional>

#include "image/image.h"

namespace strobe::image {

double meanSquaredError(const Image& test, const Image& reference, const Image& mask = {});      // mean (x-r)^2
double rootMeanSquaredError(const Image& test, const Image& reference, const Image& mask = {});  // square root of MSE

// mean (x-r)^2 / (r^2 + 0.01), without the factor 1/2 of some programs.
double relativeMse(const Image& test, const Image& reference, const Image& mask = {});

// `relativeMse` without the 0.1 % of pixels with the largest errors (mean of channels), so that fireflies do not
// dominate it.
double trimmedRelativeMse(const Image& test, const Image& reference, const Image& mask = {});

// mean |x-r| / (|x| + |r| + 0.01), in [0,1).
double smape(const Image& test, const Image& reference, const Image& mask = {});

// 10 log10(1 / MSE) of the clamped, sRGB-encoded values; +infinity for identical values.
double psnr(const Image& test, const Image& reference, const Image& mask = {});

// Wang et al. 2004 on the clamped, sRGB-encoded values: 11x11 Gaussian window of sigma 1.5, K1 = 0.01, K2 = 0.03, L =
// 1, population moments; mean over the channels and over the pixels with a window inside the image. Absent if a side is
// shorter than the window.
std::optional<double> ssim(const Image& test, const Image& reference, const Image& mask = {});

// Wang, Simoncelli, Bovik 2003 on the values that `ssim` reads: contrast and structure at five scales (2x average
// between them), luminance at the last. A negative mean counts as 0. Absent if a side is shorter than 176 pixels.
std::optional<double> multiScaleSsim(const Image& test, const Image& reference);

// mean |(x1 - x0) - (r1 - r0)|: flicker of an animation that its reference lacks.
double temporalError(const Image& test0, const Image& test1, const Image& reference0, const Image& reference1,
                     const Image& mask = {});

// Number of selected pixels, and the mean and the largest value of a one-channel map (an error map of flip.h) over
// these pixels.
size_t countedPixels(const Image& image, const Image& mask);
double meanOf(const Image& map, const Image& mask = {});
double largestOf(const Image& map, const Image& mask = {});

}  // namespace strobe::image
