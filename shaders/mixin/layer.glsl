// SPDX-License-Identifier: MIT
// Needs: color_tex, depth_tex, velocity_tex, params.limit, background_depth_tex, background_valid_tex, valid_tex; may have:
//   max_displacement_buf, max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
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

// Displacement of a texel, shortened to the limit (mixin/limit.glsl).
vec2 limited(vec4 texel) { return clampLength(finiteDisplacement(texel), limitPx()); }

Texel texelAt(ivec2 pixel) {
  vec2 d = limited(velocity_at(pixel));
  return Texel(finiteColor(color_at(pixel)), saneDepth(depth_at(pixel).x), d);
}

// True if the layer has a surface at the pixel.
bool isValid(ivec2 pixel) { return valid_at(pixel).x > 0.5; }

// True if the revealed layer has a surface behind the pixel.
bool hasBackground(ivec2 pixel) { return background_valid_at(pixel).x > 0.5; }

// View depth of the revealed layer, metres; `otherwise` if this layer has no surface at the pixel.
float backgroundDepth(ivec2 pixel, float otherwise) {
  return hasBackground(pixel) ? saneDepth(background_depth_at(pixel).x) : otherwise;
}

#endif
