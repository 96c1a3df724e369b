// SPDX-License-Identifier: MIT
// How much there is to see in an image, and where two images differ. Colours are the first three channels (or those
// there are); images of a pair have the same size. `mask` as in metrics.h: a pixel counts where its first channel is at
// least 0.5; without a mask every pixel does.
#pragma once

#include "image/image.h"

namespace strobe::image {

bool isIn(const Image& mask, int x, int y);

// Root mean square of the channels' standard deviations; NaN where no pixel counts.
double contrast(const Image& image, const Image& mask = {});

// Largest magnitude of a colour's channel.
double largestColour(const Image& image, const Image& mask = {});

// The largest difference of a channel and its pixel, the first of equal ones. A difference that is no number counts as
// infinite.
struct Difference {
  double value = 0;
  int x = 0, y = 0;
};
Difference largestDifference(const Image& a, const Image& b, const Image& mask = {});

// Number of pixels with a colour that is not finite; place and value of the first in reading order.
struct NotFinite {
  size_t pixels = 0;
  int x = 0, y = 0;
  float value = 0;
};
NotFinite notFiniteIn(const Image& image);

// Pixels of which a channel differs by more than the tolerance, or by no number.
int countDifferent(const Image& a, const Image& b, double tolerance, const Image& mask = {});

}  // namespace strobe::image
