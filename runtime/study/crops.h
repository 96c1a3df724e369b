// SPDX-License-Identifier: MIT
// Where crops lie, and pictures made smaller for people.
#pragma once

#include "image/draw.h"
#include "image/image.h"

namespace strobe::study {

// `crop` in a picture whose sides are so many times those it was written for; at least a pixel, inside the picture.
image::Rectangle scaledCrop(const image::Rectangle& crop, double scale_x, double scale_y, const image::Image& picture);

// Where most of a mask lies: the best place for a window of this size; of equally dense ones that with the fullest
// middle.
image::Rectangle densestCrop(const image::Image& mask, int width, int height);

// Mean of the linear colours below each pixel of the result; neither side grows.
image::Image shrunk(const image::Image& linear, int width, int height);

}  // namespace strobe::study
