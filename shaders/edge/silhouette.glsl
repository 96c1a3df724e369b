// SPDX-License-Identifier: MIT
// Silhouettes between instances that stand off: a pixel is an edge if one of its four neighbours is another instance,
// farther, and off the plane that the pixel lies on. What rests on something, as a box on the floor, is no silhouette
// where they touch.
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), normal (unit, world; sky 0), where (> 1/2: look here;
//      absent: everywhere).
// Out: edge, 1 on an edge: one pixel wide, on the nearer side.
// Fails: blind to self-occlusion of one instance, and to what lies behind in the same plane (which, by distance, curved
//   surfaces reach behind their silhouettes).
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
