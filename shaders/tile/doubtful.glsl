// SPDX-License-Identifier: MIT
// Per cell, whether anything comes there within the exposure of which layers do not say truly where it is.
// In:  bounds, behind_bounds (of the displacements in each cell of what is doubtful at the capture, in both layers);
//      open_bounds, close_bounds (the same of what is seen at the ends of the exposure); reach (px over the exposure).
// Out: doubtful (1: it comes).
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

const float kSlack = 2.0;  // px: rounding, and the width of a tap

bool comesHere(ivec2 here, ivec2 cell, vec4 bounds, vec2 window) {
  if (isEmpty(bounds)) return false;
  vec4 way = travelled(bounds, window);
  vec2 from = vec2(cell * params.cell_side), to = from + float(params.cell_side);
  vec2 low = vec2(here * params.cell_side), high = low + float(params.cell_side);
  return all(lessThanEqual(from + lowOf(way) - kSlack, high)) && all(greaterThanEqual(to + highOf(way) + kSlack, low));
}

void run(ivec2 cell) {
  ivec2 cells = textureSize(bounds_tex, 0);
  int around = tilesInReach(3.0 * reachPx() + kSlack, params.cell_side, vec2(-1, 0), cells);
  ivec2 from = max(cell - around, ivec2(0)), to = min(cell + around, cells - 1);
  bool comes = false;
  for (int y = from.y; y <= to.y && !comes; ++y) {
    for (int x = from.x; x <= to.x && !comes; ++x) {
      ivec2 at = ivec2(x, y);
      comes = comesHere(cell, at, texelFetch(bounds_tex, at, 0), frame.shutter);
#if HAS_behind_bounds
      comes = comes || comesHere(cell, at, texelFetch(behind_bounds_tex, at, 0), frame.shutter);
#endif
#if HAS_open_bounds
      comes = comes || comesHere(cell, at, texelFetch(open_bounds_tex, at, 0), frame.shutter - frame.shutter.x);
#endif
#if HAS_close_bounds
      comes = comes || comesHere(cell, at, texelFetch(close_bounds_tex, at, 0), frame.shutter - frame.shutter.y);
#endif
    }
  }
  imageStore(doubtful_img, cell, vec4(comes ? 1 : 0));
}
