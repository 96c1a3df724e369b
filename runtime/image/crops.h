// SPDX-License-Identifier: MIT
// Placement of crops.
#pragma once

#include "image/draw.h"
#include "image/image.h"

namespace strobe::image {

// Scales `crop` with the sides of a picture. The result has at least one pixel and lies inside the picture.
Rectangle scaledCrop(const Rectangle& crop, double scale_x, double scale_y, const Image& picture);

// Window of this size with the most pixels of a mask. Of several windows, the window with the most mask pixels in its
// middle.
Rectangle densestCrop(const Image& mask, int width, int height);

// Window of this size with the largest sum of a map of one channel; the first of several.
Rectangle worstWindow(const Image& map, int width, int height);

}  // namespace strobe::image
