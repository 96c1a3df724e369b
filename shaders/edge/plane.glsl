// SPDX-License-Identifier: MIT
// Edge detector: marks pixels whose neighbours lie off the plane of the pixel's surface, or have a different normal.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is two pixels wide at a step, one pixel on each side.
// Method: the depth step is the largest deviation of the four neighbours from the plane that touches the pixel's surface, as a
//   share of the pixel's depth (mixin/edge_plane.glsl; the parameter `measure` chooses second differences or distances). The
//   normal step, which finds creases, is the largest difference between the normals of the pixel and a neighbour.
//   Each step is divided by its threshold. The parameter `combine` selects the larger quotient, the sum or the smaller quotient.
//   The pixel is an edge if this number exceeds 1.
// Fails: misses farther surfaces in the same plane. Quantised depths make false edges.
//   Second differences (of 1/z, z: view depth) miss a step if one neighbour is nearer and the opposite neighbour is farther by
//   an equal difference of 1/z. They do not exist across the border of the image.
//   Distances from the plane miss silhouettes of curved surfaces: there the plane runs along the view ray.
#include "mixin/edge.glsl"
#include "mixin/edge_plane.glsl"
#include "mixin/edge_steps.glsl"

float normalStep(ivec2 pixel, ivec2 offset) { return length(normalAt(pixel + offset) - normalAt(pixel)); }

void run(ivec2 pixel) {
  const ivec2 neighbours[4] = ivec2[](ivec2(1, 0), ivec2(0, 1), ivec2(-1, 0), ivec2(0, -1));
  float depth = depthAt(pixel);
  bool edge = false;
  if (isWanted(pixel) && isSurface(depth)) {
    float depth_step = 0.0, normal_step = 0.0;
    for (int i = 0; i < 4; ++i) {
      depth_step = max(depth_step, planeBreak(pixel, neighbours[i], depth));
      normal_step = max(normal_step, normalStep(pixel, neighbours[i]));
    }
    edge = combined(depth_step, normal_step) > 1.0;
  }
  markEdge(pixel, edge);
}
