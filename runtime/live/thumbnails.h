// SPDX-License-Identifier: MIT
// Small pictures of a sweep, side by side in one display image.
#pragma once

#include <array>
#include <vector>

#include "image/image.h"

namespace strobe::live {

class Sweep;

// Picture reduced by box filtering until no side is longer than a thumbnail's; never enlarged.
image::Image reduced(const image::Image& linear);

// Sheet of equal cells, row by row, with an exposure in stops. The cell of a point without a picture is dark. Cells
// show the crop with the largest error of all points, or the whole picture until every point has an error.
struct Thumbnails {
  image::Image sheet;
  std::vector<std::array<float, 4>> places;  // left, top, right, bottom of each point, fractions of the sheet's size
};
Thumbnails thumbnailsOf(const Sweep& sweep, double stops);

}  // namespace strobe::live
