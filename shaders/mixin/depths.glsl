// SPDX-License-Identifier: MIT
// Needs: nothing; may have: depth_change_tex.
// View depths at the time of a tap, where a filter is given by how much they change; else those of the capture, with no
// arithmetic more. Which of two surfaces is in front is asked of depths at one time.
#ifndef STROBE_DEPTHS_GLSL
#define STROBE_DEPTHS_GLSL
#include "lib/sanitise.glsl"

// Of what is at a depth, t exposures later; `change` is what scene/depth_change.glsl writes. What has passed the camera hides
// nothing: it is as far away as the sky.
float depthThen(float depth, vec4 change, float t) {
  vec2 paces = finiteDisplacement(change);
  float then = depth + (t < 0.0 ? paces.x : paces.y) * t;
  return then > 0.0 ? then : uintBitsToFloat(0x7f800000u);
}

// At time t, of what raster saw at a pixel, where it is at `depth` at the capture.
float depthAt(ivec2 pixel, float depth, float t) {
#if HAS_depth_change
  return depthThen(depth, texelFetch(depth_change_tex, pixel, 0), t);
#else
  return depth;
#endif
}

#endif
