// SPDX-License-Identifier: MIT
// Needs: hit_tex, mask_tex.
// Squares of side x side pixels that share one ray.
#ifndef STROBE_SQUARE_GLSL
#define STROBE_SQUARE_GLSL

// Is something to be revealed behind this pixel? Behind the sky there is nothing.
bool isMasked(ivec2 pixel) {
  return texelFetch(mask_tex, pixel, 0).r > 0.5 && texelFetch(hit_tex, pixel, 0).x != 0u;
}

// The pixel whose ray stands for a square: its first masked one, row by row; (-1, -1) if none is.
ivec2 sourcePixel(ivec2 square, int side) {
  ivec2 size = textureSize(hit_tex, 0);
  for (int i = 0; i < side * side; ++i) {
    ivec2 pixel = square * side + ivec2(i % side, i / side);
    if (pixel.x < size.x && pixel.y < size.y && isMasked(pixel)) return pixel;
  }
  return ivec2(-1);
}

#endif
