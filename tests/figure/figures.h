// SPDX-License-Identifier: MIT
// Synthetic pictures with known values, and figures of these pictures.
#pragma once

#include <string>

#include "figure/figure.h"

namespace strobe::figure {

inline constexpr int kWidth = 64, kHeight = 36;

// Shot "still" by arms "plain" and "truth", whose colours differ, at any step: `color` with a distinct value per pixel,
// `velocity` of (12, 0) px in the left half, `half.speed` of half the size, `depth`, and truth's regions. The camera
// looks along -z; the node "ball" is at pixel (48, 9), "behind" is behind the camera.
const Taken& findTaken(const std::string& shot, const std::string& arm, int step);

// Data that scripts/strobe/figure.lua makes from a figure or film in Lua. Throws the script's `Error`.
Json dataOf(const std::string& lua, const std::string& kind = "figure");

inline Layout layoutOf(const std::string& lua) { return layoutOf(figureFrom(dataOf(lua)), findTaken, "truth"); }

Colour colourAt(const image::Image& image, int x, int y);
// Largest difference of two colours over the channels, in 255 levels.
int levelsApart(const Colour& a, const Colour& b);

}  // namespace strobe::figure
