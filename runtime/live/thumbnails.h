// SPDX-License-Identifier: MIT
// Small pictures of a sweep, side by side in one display image.
#pragma once

#include <array>

#include "live/sweep.h"

namespace strobe::live {

// The mean of what falls into each pixel, shown with an exposure in stops; never enlarged. `width`: at most so wide.
image::Image thumbnail(const image::Image& linear, int width, double stops);

// A sheet of equal cells, row by row; those of points without a picture are dark.
struct Thumbnails {
  image::Image sheet;
  std::vector<std::array<float, 4>> places;  // of each point in the sheet: left, top, right, bottom in shares of it
};
Thumbnails thumbnailsOf(const Sweep& sweep, double stops);

}  // namespace strobe::live
