// SPDX-License-Identifier: MIT
// The part of the picture that motion may reach.
#ifndef STROBE_REACHED_GLSL
#define STROBE_REACHED_GLSL

// Can anything that moves be seen there?
bool isReached(ivec2 pixel) {
  return all(greaterThanEqual(pixel, frame.reach.xy)) && all(lessThan(pixel, frame.reach.zw));
}

#endif
