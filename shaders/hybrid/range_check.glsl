// SPDX-License-Identifier: MIT
// Range check of the ray mask. It marks moving pixels with an edge on the segment of their displacement (Tan, Cui, Bhojan 2020,
// section Ray Mask).
// In:  edge: > 1/2 on an edge.
//      id: instance + 1; 0 for the sky.
//      velocity: displacement d, px over the exposure.
// Out: mask: 1 where `ray_reveal` is to look for the surface behind, otherwise 0.
// Method: a pixel X with |d| >= `min_displacement` is marked if a pixel of the segment is an edge. The segment, X included, is
//   [X, X + d] if the exposure lies before the raster time, [X - d, X] if it lies after, and [X - d/2, X + d/2] if it lies
//   around.
//   Each side of X is tested in `taps` steps. 0 means one step per pixel, because an edge may be one pixel wide and longer
//   steps miss it.
//   With own_edge, the first edge met must belong to the instance of X.
// Fails: the motion of the pixel itself decides, although its motion relative to the background matters.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

bool isMarkedBy(ivec2 pixel, ivec2 at) {
#if PARAM_own_edge
  return texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x;
#else
  return true;
#endif
}

bool meetsEdge(ivec2 pixel, vec2 d, float t) {
  vec2 whole = tapOffset(d, t);
  int steps = params.taps > 0 ? params.taps : int(ceil(lengthOf(whole)));
  for (int i = 0; i <= steps; ++i) {
    ivec2 at = pixel + roundSymmetric(whole * (float(i) / float(max(steps, 1))));
    if (!isInside(at, textureSize(edge_tex, 0))) return false;
    if (texelFetch(edge_tex, at, 0).x > 0.5) return isMarkedBy(pixel, at);
  }
  return false;
}

void run(ivec2 pixel) {
  vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  d = clampLength(d, limitPx());
  bool mask = false;
  if (lengthOf(d) >= params.min_displacement) {
    mask = meetsEdge(pixel, d, frame.shutter.x) || meetsEdge(pixel, d, frame.shutter.y);
  }
  imageStore(mask_img, pixel, vec4(mask ? 1 : 0));
}
