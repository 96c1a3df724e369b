// SPDX-License-Identifier: MIT
// Needs: color_tex, depth_tex, velocity_tex, params.limit; may have: behind_depth_tex,
//   behind_valid_tex, reach_tex, valid_tex.
// One layer of the picture as gathers read it, and the revealed layer behind it.
#ifndef STROBE_LAYER_GLSL
#define STROBE_LAYER_GLSL
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

struct Texel {
  vec3 color;   // linear, finite
  float depth;  // view depth, sky +inf
  vec2 d;       // px over the exposure, at most limit * image width long
};

vec2 limited(vec4 texel) { return clampLength(finiteDisplacement(texel), limitPx()); }

Texel texelAt(ivec2 pixel) {
  vec2 d = limited(texelFetch(velocity_tex, pixel, 0));
  return Texel(finiteColor(texelFetch(color_tex, pixel, 0)), saneDepth(texelFetch(depth_tex, pixel, 0).x), d);
}

// Does the layer hold anything there?
bool isValid(ivec2 pixel) {
#if HAS_valid
  return texelFetch(valid_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

// Was something revealed behind it?
bool hasBehind(ivec2 pixel) {
#if HAS_behind_valid
  return texelFetch(behind_valid_tex, pixel, 0).x > 0.5;
#else
  return false;
#endif
}

float behindDepth(ivec2 pixel, float otherwise) {
#if HAS_behind_depth
  if (hasBehind(pixel)) return saneDepth(texelFetch(behind_depth_tex, pixel, 0).x);
#endif
  return otherwise;
}

#endif
