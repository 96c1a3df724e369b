// SPDX-License-Identifier: MIT
// Silhouettes between instances: a pixel is an edge if one of its four neighbours is another instance and farther.
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: one pixel wide, on the nearer side. Of equal depths neither is an edge.
// Fails: contacts and intersections of resting parts are edges too; blind to self-occlusion of one instance.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

bool isBeyond(ivec2 pixel, ivec2 offset) {
  ivec2 at = clampToImage(pixel + offset, textureSize(depth_tex, 0));
  if (texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  return saneDepth(texelFetch(depth_tex, at, 0).x) > saneDepth(texelFetch(depth_tex, pixel, 0).x);
}

bool isWanted(ivec2 pixel) {
#if HAS_where
  return texelFetch(where_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

void run(ivec2 pixel) {
  bool edge = isWanted(pixel) && (isBeyond(pixel, ivec2(1, 0)) || isBeyond(pixel, ivec2(-1, 0)) ||
                                  isBeyond(pixel, ivec2(0, 1)) || isBeyond(pixel, ivec2(0, -1)));
  imageStore(edge_img, pixel, vec4(edge ? 1 : 0));
}
