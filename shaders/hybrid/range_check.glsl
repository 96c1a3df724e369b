// SPDX-License-Identifier: MIT
// Range check of the ray mask: marks moving pixels with an edge within their displacement (Tan, Cui, Bhojan 2020, section Ray
// Mask). The background behind such a silhouette is disoccluded within the exposure.
// In:  `edge`: edge mask, above 1/2 on an edge.
//      `id`: instance + 1; 0 for the sky.
//      `velocity`: displacement d of each pixel's surface, px over the exposure.
// Out: `mask`: 1 where the pass `ray_reveal` traces a ray to the background, otherwise 0.
// Method: a pixel X with |d| >= `min_displacement` is marked if a pixel of its segment is an edge. The segment includes X. It
//   is [X, X + d] if the exposure ends at the raster time, [X - d, X] if it starts there, and [X - d/2, X + d/2] if it is
//   centred.
//   Each side of X is tested in `taps` steps. With `taps` = 0, one step is one pixel, because an edge may be one pixel wide,
//   and longer steps miss it. With `own_edge`, only the first edge on each side counts, and only if it belongs to the instance
//   of X.
// Fails: uses the motion of the pixel itself, although disocclusion depends on the motion of the pixel relative to the
//   background.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

// True if the first edge, at the pixel `at`, counts for `pixel`.
bool isMarkedBy(ivec2 pixel, ivec2 at) {
#if PARAM_own_edge
  return texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x;
#else
  return true;
#endif
}

// True if the side of the segment towards time t contains an edge that counts.
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
