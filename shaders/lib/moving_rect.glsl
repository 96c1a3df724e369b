// SPDX-License-Identifier: MIT
// Test if a pixel is in the moving rectangle `frame.moving_rect`: the pixels that moving surfaces can reach within the
// exposure.
#ifndef STROBE_MOVING_RECT_GLSL
#define STROBE_MOVING_RECT_GLSL

// True if a moving surface may be visible at the pixel at some time of the exposure. Conservative: also true for some other
// pixels.
bool isInMovingRect(ivec2 pixel) {
  return all(greaterThanEqual(pixel, frame.moving_rect.xy)) && all(lessThan(pixel, frame.moving_rect.zw));
}

#endif
