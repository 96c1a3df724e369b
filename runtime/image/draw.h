// SPDX-License-Identifier: MIT
// Composing pictures for people: insets, labels. Everything here takes and gives display images
// (sRGB-encoded values in [0,1], tone.h makes them) of three channels. Pixels outside an image are skipped.
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

// The part of `image` inside `area`, which is first cut to the image; any channel count. Throws `Error` when nothing
// is left.
Image crop(const Image& image, Rectangle area);

// Every pixel becomes a square of factor x factor equal ones; any channel count.
Image magnify(const Image& image, int factor);

// Each pixel is the mean of those below it, so give it linear colour; neither side grows, at least a pixel is left.
Image shrunk(const Image& linear, int width, int height);

void fill(Image& onto, Rectangle area, const Colour& colour);
void paste(Image& onto, const Image& what, int x, int y);  // top left corner of `what` at (x, y)

// Blend `colour` over the pixel (x, y); coverage in [0,1].
void blend(Image& onto, int x, int y, const Colour& colour, float coverage);

// DejaVu Sans, the font of everything the program draws. Throws `Error` saying what to install when it is absent.
Path fontFile();

// One line of text in DejaVu Sans, the top of its line box at (x, y); `size_px` is the height of that box. UTF-8.
void drawText(Image& onto, int x, int y, const std::string& text, float size_px, const Colour& colour);
int textWidth(const std::string& text, float size_px);

}  // namespace strobe::image
