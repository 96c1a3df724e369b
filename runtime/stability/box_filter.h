// SPDX-License-Identifier: MIT
// What uniform motion makes of a picture, computed on the CPU alone: the mean of the picture along the motion.
#pragma once

#include <array>

#include "image/image.h"

namespace strobe::stability {

// The part [from, to] of the exposure, the capture at 0, that a picture blurs over.
struct Window {
  double from = -1, to = 0;
};

// The mean along a segment and how far a mean of samples may be off it.
struct Mean {
  std::array<double, 3> color{};
  std::array<double, 3> variation{};  // sum of the absolute steps from pixel to pixel
  bool inside = true;                 // the segment does not leave the picture
};

// The exact mean over t in the window of the pixel that holds the point centre(x, y) - d * t; d in px over the
// exposure, x right, y down. Each pixel counts by the length of the segment in it: no samples are taken.
Mean meanAlong(const image::Image& picture, int x, int y, double dx, double dy, const Window& window);

}  // namespace strobe::stability
