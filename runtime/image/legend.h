// SPDX-License-Identifier: MIT
// Legends on display images: scales, wheels, captions, arrows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/draw.h"
#include "math/geometry.h"

namespace strobe::image {

// Text size of a legend, px. 0 for a picture that is too small for a legend; then no legend is drawn.
float legendTextSize(const Image& onto);

// Smallest number of the form 1, 2 or 5 times a power of ten that is at least `value`. 1 if `value` is not positive and
// finite.
double niceCeiling(double value);

// Draws a colour bar in the lower right corner. `colourAt` takes 0 (left) to 1 (right).
void drawBar(Image& onto, const std::function<Colour(float)>& colourAt, const std::string& left,
             const std::string& middle, const std::string& right);

// Wheel of the velocity colours of image/false_colour.h. The velocity at its rim is `full_px`.
struct Wheel {
  int x = 0, y = 0, radius = 0;  // centre, px of the picture; radius 0: the picture is too small
};
Wheel wheelOf(const Image& onto);
void drawWheel(Image& onto, double full_px);

// Draws one line of text on a dark plate in the lower right corner.
void drawCaption(Image& onto, const std::string& text);

// Draws an antialiased arrow with a dark border. `to` is its tip.
void drawArrow(Image& onto, vec2 from, vec2 to, float thickness, const Colour& colour);

}  // namespace strobe::image
