// SPDX-License-Identifier: MIT
// Drawing of insets and labels. All functions take and return three-channel display images (sRGB-encoded values in
// [0,1], made by tone.h). Pixels outside of an image are skipped.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"
#include "image/image.h"
#include "image/magma.h"

namespace strobe::image {

struct Rectangle {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

Image filled(int width, int height, const Colour& colour);

// Pixels of `image` inside `area`. `area` is first clipped to the image; any channel count. Throws `Error` if no pixel
// is left.
Image crop(const Image& image, Rectangle area);

// Repeats each pixel factor x factor times; any channel count.
Image magnify(const Image& image, int factor);

// Shrinks a linear image: each pixel is the mean of the pixels that it covers. No side grows, and at least one pixel is
// left.
Image shrunk(const Image& linear, int width, int height);

void fill(Image& onto, Rectangle area, const Colour& colour);
void paste(Image& onto, const Image& what, int x, int y);  // top left corner of `what` at (x, y)

// Blends `colour` over the pixel (x, y); coverage in [0,1].
void blend(Image& onto, int x, int y, const Colour& colour, float coverage);

// File of DejaVu Sans, the font of all drawn text. Throws `Error` with the package to install if the file is missing.
Path fontFile();

// Draws one line of UTF-8 text in DejaVu Sans. The line box has its top left corner at (x, y) and the height `size_px`.
void drawText(Image& onto, int x, int y, const std::string& text, float size_px, const Colour& colour);
int textWidth(const std::string& text, float size_px);

}  // namespace strobe::image
