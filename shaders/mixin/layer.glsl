// SPDX-License-Identifier: MIT
// Needs: color_tex, depth_tex, velocity_tex, params.limit; may have: background_depth_tex,
//   background_valid_tex, max_displacement_buf, valid_tex.
// Texels of one layer as gathers read them, and the depth of the revealed layer behind it.
#ifndef STROBE_LAYER_GLSL
#define STROBE_LAYER_GLSL
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

struct Texel {
  vec3 color;   // linear, finite
  float depth;  // view depth, metres; +inf for the sky
  vec2 d;       // px over the exposure, at most limit * image width long
};

// Displacement of a texel, shortened to the limit.
vec2 limited(vec4 texel) { return clampLength(finiteDisplacement(texel), limitPx()); }

Texel texelAt(ivec2 pixel) {
  vec2 d = limited(texelFetch(velocity_tex, pixel, 0));
  return Texel(finiteColor(texelFetch(color_tex, pixel, 0)), saneDepth(texelFetch(depth_tex, pixel, 0).x), d);
}

// True if the layer has a surface at the pixel.
bool isValid(ivec2 pixel) {
#if HAS_valid
  return texelFetch(valid_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

// True if the revealed layer has a surface behind the pixel.
bool hasBackground(ivec2 pixel) {
#if HAS_background_valid
  return texelFetch(background_valid_tex, pixel, 0).x > 0.5;
#else
  return false;
#endif
}

// View depth of the revealed layer; `otherwise` if it has no surface there.
float backgroundDepth(ivec2 pixel, float otherwise) {
#if HAS_background_depth
  if (hasBackground(pixel)) return saneDepth(texelFetch(background_depth_tex, pixel, 0).x);
#endif
  return otherwise;
}

#endif
