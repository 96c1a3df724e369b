// SPDX-License-Identifier: MIT
// Where crops lie.
#pragma once

#include "image/draw.h"
#include "image/image.h"

namespace strobe::image {

// `crop` in a picture whose sides are so many times those it was written for; at least a pixel, inside the picture.
Rectangle scaledCrop(const Rectangle& crop, double scale_x, double scale_y, const Image& picture);

// Where most of a mask lies: the best place for a window of this size; of equally dense ones that with the fullest
// middle.
Rectangle densestCrop(const Image& mask, int width, int height);

// Window of this size with the largest sum of a map of one channel; the first of several.
Rectangle worstWindow(const Image& map, int width, int height);

}  // namespace strobe::image
