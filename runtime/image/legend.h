// SPDX-License-Identifier: MIT
// Legends of display images: the meaning of their colours.
#pragma once

#include <array>
#include <string>

#include "image/draw.h"

namespace strobe::image {

// A bar of scalars or of depths (m) from low to high, a wheel of displacements up to `high` px, or text only.
struct Legend {
  enum class Kind { none, bar, depth, wheel, words };
  Kind kind = Kind::none;
  double low = 0, high = 0;
  std::string text;  // text, or the label in the middle of a bar
  bool operator==(const Legend&) const = default;
};

// Smallest number of the form 1, 2 or 5 times a power of ten that is at least `value`. 1 if `value` is not positive and
// finite.
double niceCeiling(double value);

// Colours of a bar, from its low end to its high end.
Image barOf(const Legend& legend, int width, int height);
// Square around a wheel of the velocity colours of image/false_colour.h, with 2 * radius + 1 pixels a side.
Image wheelOf(int radius);
// Texts at the left, in the middle and at the right of a legend.
std::array<std::string, 3> textsOf(const Legend& legend);

// Rectangle of a legend in the lower right corner of a picture, without the border of its plate. A wheel is at the top
// of the rectangle. Empty if the picture is too small for a legend.
Rectangle placeOf(const Legend& legend, const Image& picture);
// Draws the legend there, on a dark plate. Returns the rectangle of the plate.
Rectangle drawLegend(Image& onto, const Legend& legend);
// Image of a legend alone, to show beside or on a picture. Empty without a legend.
Image pictureOf(const Legend& legend);

}  // namespace strobe::image
