// SPDX-License-Identifier: MIT
// Copies of parts of images, and the placement of crops. Pixels outside of an image are skipped.
#pragma once

#include "image/image.h"
#include "image/magma.h"

namespace strobe::image {

// Rectangle of pixels, x right, y down.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Rectangle&) const = default;
};

// Common part of two rectangles; without pixels if there is none.
Rectangle overlap(const Rectangle& a, const Rectangle& b);

// Pixels of `image` inside `area`. `area` is first clipped to the image; any channel count. Throws `Error` if no pixel
// is left.
Image crop(const Image& image, Rectangle area);

// Repeats each pixel factor x factor times; any channel count.
Image magnify(const Image& image, int factor);

// Shrinks a linear image: each pixel is the mean of the pixels that it covers. No side grows, and at least one pixel is
// left.
Image shrunk(const Image& linear, int width, int height);

// `onto` has three channels.
void fill(Image& onto, Rectangle area, const Colour& colour);

// Scales `crop` with the sides of a picture. The result has at least one pixel and lies inside the picture.
Rectangle scaledCrop(const Rectangle& crop, double scale_x, double scale_y, const Image& picture);

// Window of this size with the most pixels of a mask. Of several windows, the window with the most mask pixels in its
// middle.
Rectangle densestCrop(const Image& mask, int width, int height);

// Window of this size with the largest sum of a map of one channel; the first of several.
Rectangle worstWindow(const Image& map, int width, int height);

}  // namespace strobe::image
