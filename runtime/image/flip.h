// SPDX-License-Identifier: MIT
// FLIP: the difference a person sees when alternating between two images (Andersson et al. 2020, "FLIP: A Difference
// Evaluator for Alternating Images"), and its high dynamic range form (Andersson et al. 2021, "Visualizing and
// Communicating Errors in Rendered Images"). Follows the published program, version 1.6.
// Images are linear RGB of the same size; one channel is taken as grey, alpha is not compared.
// A map has one channel, 0 (no difference) to 1. Symmetric in its two images (HDR: at given exposures).
#pragma once

#include <optional>

#include "image/image.h"
#include "math/constants.h"

namespace strobe::image {

// A 3840-pixel, 0.7 m wide display seen from 0.7 m.
constexpr double kPixelsPerDegree = 0.7 * 3840 / 0.7 * kPi / 180;

// LDR-FLIP of the values clamped to [0,1] (so also of the clamped form of a high dynamic range image).
Image ldrFlip(const Image& test, const Image& reference, double pixels_per_degree = kPixelsPerDegree);

enum class FlipCurve { aces, hable, reinhard };

// The exposures at which HDR-FLIP looks: `count` stops spaced evenly from `start` to `stop`, both included.
struct Exposures {
  enum class Source {
    given,      // by the caller
    reference,  // from the largest and the median luminance of the reference
    positive,   // its median is 0: the smallest positive luminance stands in for it
    test,       // the reference is black: as above, from the test image
    none,       // both are black: 0 to 0
  };
  double start = 0;
  double stop = 0;
  int count = 2;
  Source source = Source::given;
};
const char* exposureSourceName(Exposures::Source source);

// start = log2(x/Ymax), stop = log2(x/Ymedian), x where the curve reaches 0.85; count = max(2, ceil(stop - start)).
// Unlike the published program, which returns no error for any test image when at least half of the reference is
// black, a median of 0 is replaced as `source` says.
Exposures automaticExposures(const Image& test, const Image& reference, FlipCurve curve = FlipCurve::aces);

struct HdrFlipOptions {
  FlipCurve curve = FlipCurve::aces;
  std::optional<Exposures> exposures;  // give them to compare numbers across images of one scene
  double pixels_per_degree = kPixelsPerDegree;
};
struct HdrFlip {
  Image map;  // per pixel the largest LDR-FLIP of all exposures
  Exposures exposures;
};
HdrFlip hdrFlip(const Image& test, const Image& reference, const HdrFlipOptions& options = {});

}  // namespace strobe::image
