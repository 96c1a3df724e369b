// SPDX-License-Identifier: MIT
// Pictures of what is not colour: differences, scalars, velocities, ids, depths. Results are display images (tone.h).
#pragma once

#include "image/image.h"
#include "image/magma.h"

namespace strobe::image {

// |a - b| * gain per colour channel, shown as it is (no encoding): black is no difference.
Image absoluteDifference(const Image& a, const Image& b, float gain = 1);

// Marks pixels of `display` (three channels) if a colour of `data` is not finite there: magenta for NaN, else yellow.
inline constexpr Colour kNanColour = {1, 0, 1}, kInfiniteColour = {1, 1, 0};
void markNotFinite(Image& display, const Image& data);

// The mean of |a - b| over the colour channels in magma; its upper end is 1/gain.
Image differenceHeat(const Image& a, const Image& b, float gain = 1);

// The first channel in magma, `low` to `high`.
Image heatMap(const Image& scalar, float low, float high);

// x and y (down) in pixels: hue is the direction (right red, down green-yellow, left cyan, up violet), brightness the
// length up to `full_px`; black stands still, longer than `full_px` pales.
Image velocityColours(const Image& velocity, float full_px);

// A colour of its own for every id, the same in every image; 0 (nothing) is black.
Image idColours(const UintImage& ids);

// View depth in metres: magma on a logarithmic scale, `near_m` pale, `far_m` dark; nothing (infinity) is black.
Image depthColours(const Image& depth, float near_m, float far_m);

}  // namespace strobe::image
