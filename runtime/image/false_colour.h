// SPDX-License-Identifier: MIT
// False colours for differences, scalars, velocities, ids and depths. Results are display images (tone.h).
#pragma once

#include "image/image.h"
#include "image/magma.h"

namespace strobe::image {

// |a - b| * gain per colour channel, not encoded. Equal pixels are black.
Image absoluteDifference(const Image& a, const Image& b, float gain = 1);

// Marks pixels of `display` (three channels) if one of the first `channels` channels of `data` is not finite: magenta
// for NaN, yellow for infinity. `sky`: +infinity is background and is not marked.
inline constexpr Colour kNanColour = {1, 0, 1}, kInfiniteColour = {1, 1, 0};
void markNotFinite(Image& display, const Image& data, int channels = 3, bool sky = false);

// Mean of |a - b| over the colour channels in magma, from 0 to 1/gain.
Image differenceHeat(const Image& a, const Image& b, float gain = 1);

// First channel in magma, from `low` to `high`.
Image heatMap(const Image& scalar, float low, float high);

// Velocity x, y (down) in pixels. Hue is the direction (right red, down green-yellow, left cyan, up violet). Brightness
// is the length up to `full_px`; longer velocities become paler. Black is 0.
Image velocityColours(const Image& velocity, float full_px);

// One colour per id, the same in every image. Black is id 0 (nothing).
Image idColours(const UintImage& ids);

// View depth in metres, in magma on a logarithmic scale from `near_m` (pale) to `far_m` (dark). Infinity (nothing) is
// black.
Image depthColours(const Image& depth, float near_m, float far_m);

}  // namespace strobe::image
