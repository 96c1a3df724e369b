// SPDX-License-Identifier: MIT
// Contrast of an image, and differences of two images. Colours are the first three channels (or all, if there are
// fewer). Images of a pair have the same size. `mask` as in metrics.h: it selects the pixels with a first channel of at
// least 0.5; an empty mask selects all pixels.
#pragma once

#include "base/error.h"
#include "image/image.h"

namespace strobe::image {

bool isIn(const Image& mask, int x, int y);

// Calls `visit(x, y)` for each selected pixel, in reading order.
template <class Visit>
void forPixels(const Image& image, const Image& mask, Visit visit) {
  bool fits = mask.empty() || sameSize(mask, image);
  STROBE_ASSERT(fits, "{}x{} and {}x{}", image.width, image.height, mask.width, mask.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (isIn(mask, x, y)) visit(x, y);
}

// Root mean square of the channels' standard deviations; NaN if no pixel is selected.
double contrast(const Image& image, const Image& mask = {});

// Largest magnitude of a colour channel.
double largestColour(const Image& image, const Image& mask = {});

// Largest difference of a channel, and its pixel (the first of equal ones). A NaN difference counts as infinite.
struct Difference {
  double value = 0;
  int x = 0, y = 0;
};
Difference largestDifference(const Image& a, const Image& b, const Image& mask = {});

// Number of pixels with a colour that is not finite; position and value of the first one in reading order.
struct NotFinite {
  size_t pixels = 0;
  int x = 0, y = 0;
  float value = 0;
};
NotFinite notFiniteIn(const Image& image);

// Number of pixels with a channel that differs by more than the tolerance or by NaN.
int countDifferent(const Image& a, const Image& b, double tolerance, const Image& mask = {});

}  // namespace strobe::image
