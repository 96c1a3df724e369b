// SPDX-License-Identifier: MIT
// How far a test image is from its reference. x = test, r = reference, linear colour of the same size.
// Means run over the pixels that count and over the colour channels (a fourth channel, alpha, is never compared).
// `mask`: one channel is enough; a pixel counts where its first channel is at least 0.5. Empty: every pixel counts.
// Without a counting pixel every mean is NaN.
#pragma once

#include <optional>

#include "image/image.h"

namespace strobe::image {

double meanSquaredError(const Image& test, const Image& reference, const Image& mask = {});      // mean (x-r)^2
double rootMeanSquaredError(const Image& test, const Image& reference, const Image& mask = {});  // its root

// mean (x-r)^2 / (r^2 + 0.01), without the factor 1/2 some programs have.
double relativeMse(const Image& test, const Image& reference, const Image& mask = {});

// The same without the 0.1 % of pixels whose error (mean of channels) is largest: fireflies do not decide it.
double trimmedRelativeMse(const Image& test, const Image& reference, const Image& mask = {});

// mean |x-r| / (|x| + |r| + 0.01), in [0,1).
double smape(const Image& test, const Image& reference, const Image& mask = {});

// 10 log10(1 / MSE) of the clamped, sRGB-encoded values; +infinity for identical ones.
double psnr(const Image& test, const Image& reference, const Image& mask = {});

// Wang et al. 2004 on the clamped, sRGB-encoded values: 11x11 Gaussian window of sigma 1.5, K1 = 0.01, K2 = 0.03,
// L = 1, population moments; mean over the channels and over the pixels whose window lies inside the image.
// Nothing when a side is shorter than the window.
std::optional<double> ssim(const Image& test, const Image& reference, const Image& mask = {});

// Wang, Simoncelli, Bovik 2003: contrast and structure at five scales (2x average between them), luminance at the last;
// a negative mean counts as 0. The same values as `ssim`. Nothing when a side is shorter than 176 pixels.
std::optional<double> multiScaleSsim(const Image& test, const Image& reference);

// mean |(x1 - x0) - (r1 - r0)|: flicker of an animation that its reference does not have.
double temporalError(const Image& test0, const Image& test1, const Image& reference0, const Image& reference1,
                     const Image& mask = {});

// Pixels that count, and the mean of a one-channel map over them (an error map of flip.h).
size_t countedPixels(const Image& image, const Image& mask);
double meanOf(const Image& map, const Image& mask = {});
double largestOf(const Image& map, const Image& mask = {});

}  // namespace strobe::image
