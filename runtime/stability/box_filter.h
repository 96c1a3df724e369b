// SPDX-License-Identifier: MIT
// Reference blur of uniform motion on the CPU: the mean of the picture along the motion.
#pragma once

#include <array>

#include "image/image.h"

namespace strobe::stability {

// Interval [from, to] of a picture's exposure, in exposures; 0 is the raster time.
struct ExposureInterval {
  double from = -1, to = 0;
};

// Mean along a segment, with the variation that bounds the error of a mean of samples.
struct Mean {
  std::array<double, 3> color{};
  std::array<double, 3> variation{};  // sum of absolute differences from pixel to pixel
  bool inside = true;                 // the segment stays in the picture
};

// Exact mean over t in the window of the pixel at centre(x, y) - d * t; d in px over the exposure, x right, y down.
// Each pixel counts by the length of the segment in it, without sampling.
Mean meanAlong(const image::Image& picture, int x, int y, double dx, double dy, const ExposureInterval& window);

}  // namespace strobe::stability
