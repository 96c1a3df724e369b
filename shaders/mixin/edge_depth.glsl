// SPDX-License-Identifier: MIT
// Needs: depth_tex.
// The depth that edge detectors see: view depth, sky +inf.
#ifndef STROBE_EDGE_DEPTH_GLSL
#define STROBE_EDGE_DEPTH_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

// Depths beyond this many times a pixel's own count as this many times it, the sky among them.
const float kFarthest = 16.0;

// Outside of the picture its border goes on.
float depthAt(ivec2 pixel) {
  return saneDepth(texelFetch(depth_tex, clampToImage(pixel, textureSize(depth_tex, 0)), 0).x);
}

// Something whose depth others can be compared with: the sky has no edge of its own.
bool isSurface(float depth) { return depth > 0.0 && depth <= kLargestFinite; }

#endif
