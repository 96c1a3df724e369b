// SPDX-License-Identifier: MIT
// Silhouettes between instances that do not touch: pixels with a neighbour that shows another instance, farther than the pixel
// and off the pixel's plane.
// In:  `depth`:  view depth, m; +inf for the sky
//      `id`:     instance + 1; 0 for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: one pixel wide, on the nearer side
// Method: compare id, depth and distance from the pixel's plane (mixin/edge_plane.glsl) with the four neighbours. An object
//      that rests on another, for example a box on the floor, has no silhouette along the contact.
// Fails: self-occlusion of one instance is missed. A background in the same plane is missed too. With distances, the plane of a
//      curved surface contains the background at the silhouette of this surface.
#include "mixin/edge.glsl"
#include "mixin/edge_id.glsl"
#include "mixin/edge_plane.glsl"

bool standsOff(ivec2 pixel, ivec2 offset, float depth) {
  return isBeyond(pixel, offset) && planeBreak(pixel, offset, depth) > params.depth_threshold;
}

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  bool edge = isWanted(pixel) && isSurface(depth) &&
              (standsOff(pixel, ivec2(1, 0), depth) || standsOff(pixel, ivec2(-1, 0), depth) ||
               standsOff(pixel, ivec2(0, 1), depth) || standsOff(pixel, ivec2(0, -1), depth));
  markEdge(pixel, edge);
}
