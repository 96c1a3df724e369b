// SPDX-License-Identifier: MIT
// Small pictures of a sweep, side by side in one display image.
#pragma once

#include <array>
#include <vector>

#include "image/image.h"

namespace strobe::live {

class Sweep;

// The mean of what falls into each pixel, so that no side is longer than a thumbnail's; never enlarged.
image::Image reduced(const image::Image& linear);

// A sheet of equal cells, row by row, shown with an exposure in stops; those of points without a picture are dark.
// Cells show the crop with the largest error of all points, or the whole picture while there is no error.
struct Thumbnails {
  image::Image sheet;
  std::vector<std::array<float, 4>> places;  // of each point in the sheet: left, top, right, bottom in shares of it
};
Thumbnails thumbnailsOf(const Sweep& sweep, double stops);

}  // namespace strobe::live
