// SPDX-License-Identifier: MIT
// Needs: depth_tex.
// View depth for edge detectors, metres; +inf for the sky.
#ifndef STROBE_EDGE_DEPTH_GLSL
#define STROBE_EDGE_DEPTH_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

// Largest ratio of two depths that a detector uses. A surface farther than this multiple of the tested pixel's depth, or the
// sky, counts as this far, so that differences of depths stay finite. Any value well above 1 plus the depth threshold
// makes a step to such a surface an edge. With 8 or 32 instead of 16, the pipeline hybrid gives the same pictures of
// five scenes.
const float kFarthest = 16.0;

// View depth at a pixel, metres; +inf for the sky. Outside of the image: depth at the nearest border pixel.
float depthAt(ivec2 pixel) {
  return saneDepth(texelFetch(depth_tex, clampToImage(pixel, textureSize(depth_tex, 0)), 0).x);
}

// True if the depth belongs to a surface: it is finite and above 0. Detectors mark no edges on the sky.
bool isSurface(float depth) { return depth > 0.0 && depth <= kLargestFinite; }

#endif
