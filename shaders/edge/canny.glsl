// SPDX-License-Identifier: MIT
// Edge hysteresis: keeps strong ridges and the weak ridges connected to them; last of three steps of the Canny detector (Canny
// 1986).
// In:  `ridge`: 1 strong, 1/2 weak, 0 none (edge/canny/thin)
//      `where`: above 1/2 where to mark; absent: everywhere
// Out: `edge`:  1 on an edge, one pixel wide
// Method: flood from each weak pixel along ridges, to eight neighbours and within `reach` px to either side, until the flood
//      meets a strong pixel or has no pixel left. A set of pixels is one word per row, with one bit per column.
// Fails: weak and strong ridges with a connection longer than `reach` px along x or y, or with a detour out of that square,
//      count as not connected. The weak part of such an edge ends `reach` px from its strong part.
#include "lib/blur.glsl"
#include "mixin/edge.glsl"

const int kMostSide = 31;  // 2 * 15 + 1, where 15 is the largest `reach`; a row of bits fits into a word

float ridgeAt(ivec2 pixel) {
  return isInside(pixel, textureSize(ridge_tex, 0)) ? texelFetch(ridge_tex, pixel, 0).x : 0.0;
}

// True if the flood from a weak pixel meets a strong one.
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
