// SPDX-License-Identifier: MIT
// What is drawn on top of a view so that it can be read: scales, wheels, arrows. Onto display images.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/draw.h"
#include "math/geometry.h"

namespace strobe::image {

// Of a picture of that size; 0 where a legend would cover too much of it, then none is drawn.
float legendTextSize(const Image& onto);

// The smallest of 1, 2, 5 times a power of ten that is at least `value` (1 for what is not positive and finite).
double niceCeiling(double value);

// A bar in the lower right corner; `colourAt` is asked for 0 (left) to 1 (right).
void drawBar(Image& onto, const std::function<Colour(float)>& colourAt, const std::string& left,
             const std::string& middle, const std::string& right);

// A wheel of image/false_colour.h's velocity colours, its rim at `full_px`.
struct Wheel {
  int x = 0, y = 0, radius = 0;  // centre, in pixels of the picture; radius 0: too small a picture
};
Wheel wheelOf(const Image& onto);
void drawWheel(Image& onto, double full_px);

// One line of text on a dark plate in the lower right corner.
void drawCaption(Image& onto, const std::string& text);

// An arrow with its tip at `to`, smooth at its rims, with a dark border.
void drawArrow(Image& onto, vec2 from, vec2 to, float thickness, const Colour& colour);

}  // namespace strobe::image
