// SPDX-License-Identifier: MIT
// Edge detector: marks the silhouettes of instances, except along contacts. An edge is a pixel with a neighbour on another
// instance that is farther away and off the plane of the pixel's surface.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `id`: instance + 1; 0 for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is one pixel wide and lies on the nearer instance.
// Method: compare id, depth and distance from the plane of the pixel's surface (mixin/edge_plane.glsl) with the four
//   neighbours. The parameter `measure` chooses how the distance is computed. An object that rests on another, for example a
//   box on the floor, has no edge along the contact, because the farther point there is near the plane of the nearer surface.
// Fails: misses silhouettes of an instance in front of itself, and backgrounds in the plane of the foreground. With `measure` =
//   distance, misses silhouettes of curved surfaces: there the plane runs along the view ray and meets the background.
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
