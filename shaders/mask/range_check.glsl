// SPDX-License-Identifier: MIT
// Range check (Tan, Cui, Bhojan 2020, Ray Mask): every moving pixel from which an edge lies within its displacement.
// In:  edge (> 1/2 on an edge), id (instance + 1), velocity (px over the exposure).
// Out: mask, 1 if the pixel itself or a pixel on the segment it is displaced along is an edge: [X, X + d] for an
//   exposure before the capture, [X - d, X] after, both halves around it. `taps` steps per side, 0 = one per pixel of
//   the length; a detected edge may be one pixel wide, so longer steps miss it. With own_edge, the first edge met must
//   belong to the pixel's own instance.
// Fails: marks by the pixel's own motion, where the motion relative to what is behind decides.
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
