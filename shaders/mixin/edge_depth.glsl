// SPDX-License-Identifier: MIT
// Needs: depth_tex.
// View depth for edge detectors, metres; +inf for the sky.
#ifndef STROBE_EDGE_DEPTH_GLSL
#define STROBE_EDGE_DEPTH_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

// Bound of depths, the sky's included, as a multiple of the pixel's own depth.
const float kFarthest = 16.0;

// View depth at a pixel; outside of the image, at the nearest border pixel.
float depthAt(ivec2 pixel) {
  return saneDepth(texelFetch(depth_tex, clampToImage(pixel, textureSize(depth_tex, 0)), 0).x);
}

// True for the finite depth of a surface. The sky has no edges of its own.
bool isSurface(float depth) { return depth > 0.0 && depth <= kLargestFinite; }

#endif
