// SPDX-License-Identifier: MIT
// FLIP: the difference that a person perceives when alternating between two images (Andersson et al. 2020, "FLIP: A
// Difference Evaluator for Alternating Images"), and its high dynamic range form (Andersson et al. 2021, "Visualizing
// and Communicating Errors in Rendered Images"). The implementation follows the published program, version 1.6.
// Images are linear RGB of the same size. A single channel is grey; alpha is not compared.
// A map has one channel, from 0 (no difference) to 1. FLIP is symmetric in its two images (HDR: at given exposures).
#pragma once

#include <optional>

#include "image/image.h"
#include "math/constants.h"

namespace strobe::image {

// Display with a width of 3840 px and 0.7 m, at a distance of 0.7 m.
constexpr double kPixelsPerDegree = 0.7 * 3840 / 0.7 * kPi / 180;

// LDR-FLIP of the values clamped to [0,1].
Image ldrFlip(const Image& test, const Image& reference, double pixels_per_degree = kPixelsPerDegree);

// Exposures of HDR-FLIP: `count` stops, evenly spaced from `start` to `stop`, both included.
struct Exposures {
  enum class Source {
    given,      // by the caller
    reference,  // largest and median luminance of the reference
    positive,   // the median of the reference is 0; replaced by its smallest positive luminance
    test,       // the reference is black; from the test image in the same way
    none,       // both images are black; 0 to 0
  };
  double start = 0;
  double stop = 0;
  int count = 2;
  Source source = Source::given;
};
const char* exposureSourceName(Exposures::Source source);

// start = log2(x/Ymax), stop = log2(x/Ymedian), count = max(2, ceil(stop - start)). The curve reaches 0.85 at x. A
// median of 0 is replaced, see `Exposures::Source`. The published program does not replace the median; it returns no
// error for any test image if at least half of the reference is black.
Exposures automaticExposures(const Image& test, const Image& reference);

// HDR-FLIP error of an image pair: a map from 0 (no difference) to 1, and the exposures that were used.
struct HdrFlip {
  Image map;  // per pixel, the largest LDR-FLIP of all exposures
  Exposures exposures;
};
// HDR-FLIP with the ACES tone curve. With `exposures`, numbers are comparable across images of one scene; without, the
// exposures are automatic.
HdrFlip hdrFlip(const Image& test, const Image& reference, const std::optional<Exposures>& exposures = {},
                double pixels_per_degree = kPixelsPerDegree);

}  // namespace strobe::image
