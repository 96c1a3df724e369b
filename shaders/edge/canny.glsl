// SPDX-License-Identifier: MIT
// Edge detector `canny`, last of three steps: hysteresis, which keeps strong ridges and the weak ridges connected to them
// (Canny 1986).
// In:  `ridge`: class of the pixel: 1 strong ridge, 1/2 weak ridge, 0 otherwise (edge/canny/thin.glsl).
//      `where`: mask, above 1/2 where edges may be marked (absent: everywhere).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is one pixel wide.
// Method: strong pixels are edges. From each weak pixel, flood along the pixels of ridges, to all eight neighbours, within the
//   square of `reach` px to either side. If the flood meets a strong pixel, the weak pixel is an edge. The square is stored as
//   one word per row, with one bit per column.
// Fails: a weak pixel is lost if its connection to a strong pixel is longer than `reach` px along x or y, or leaves the square.
//   The weak part of a long edge therefore ends `reach` px from its strong part.
#include "lib/blur.glsl"
#include "mixin/edge.glsl"

// Largest side of the square around a weak pixel, px: 2 * 15 + 1, where 15 is the largest `reach`. A row fits into one word.
const int kMostSide = 31;

float ridgeAt(ivec2 pixel) {
  return isInside(pixel, textureSize(ridge_tex, 0)) ? texelFetch(ridge_tex, pixel, 0).x : 0.0;
}

// True if the flood from a weak pixel meets a strong pixel. `ridge`, `strong`, `found`: pixels of the square that are on a
// ridge, that are strong, and that the flood has reached; one word per row.
bool meetsStrong(ivec2 pixel) {
  int side = 2 * params.reach + 1;
  uint ridge[kMostSide], strong[kMostSide], found[kMostSide];
  for (int y = 0; y < side; ++y) {
    ridge[y] = strong[y] = found[y] = 0u;
    for (int x = 0; x < side; ++x) {
      float value = ridgeAt(pixel + ivec2(x, y) - params.reach);
      ridge[y] |= value > 0.25 ? 1u << x : 0u;
      strong[y] |= value > 0.75 ? 1u << x : 0u;
    }
  }
  found[params.reach] = 1u << params.reach;
  for (bool grows = true; grows;) {
    grows = false;
    for (int y = 0; y < side; ++y) {
      uint beside = found[y] | (y > 0 ? found[y - 1] : 0u) | (y + 1 < side ? found[y + 1] : 0u);
      uint now = (beside | beside << 1 | beside >> 1) & ridge[y];
      if ((now & strong[y]) != 0u) return true;
      grows = grows || now != found[y];
      found[y] = now;
    }
  }
  return false;
}

void run(ivec2 pixel) {
  float ridge = ridgeAt(pixel);
  bool edge = isWanted(pixel) && (ridge > 0.75 || (ridge > 0.25 && meetsStrong(pixel)));
  markEdge(pixel, edge);
}
