// SPDX-License-Identifier: MIT
// Pictures that no device drew, of which every value is known, and figures of them.
#pragma once

#include <string>

#include "figure/figure.h"

namespace strobe::figure {

inline constexpr int kWidth = 64, kHeight = 36;

// Shot "still" drawn by "plain" and "truth", which are off from each other, at any step: `color` with values that tell
// the pixels apart, `velocity` of (12, 0) px in the left half, `half.speed` of half the size, `depth`, and truth's
// regions. The camera looks along -z; the node "ball" is seen at the pixel (48, 9), "behind" is behind the camera.
const Taken& findTaken(const std::string& shot, const std::string& arm, int step);

// What scripts/strobe/figure.lua makes of a figure, or a film, written in Lua. Throws `Error` as it says.
Json dataOf(const std::string& lua, const std::string& kind = "figure");

// Laid out.
inline Layout layoutOf(const std::string& lua) { return layoutOf(figureFrom(dataOf(lua)), findTaken, "truth"); }

Colour colourAt(const image::Image& image, int x, int y);
// How many of 255 levels two colours differ in their worst channel.
int levelsApart(const Colour& a, const Colour& b);

}  // namespace strobe::figure
