// SPDX-License-Identifier: MIT
// Needs: color_tex, depth_tex, velocity_tex, params.limit, background_depth_tex, background_valid_tex, valid_tex; may have:
//   max_displacement_buf, max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Access to one layer for gathers: colour, depth and displacement of its texels, and the depth of the revealed layer behind
// this layer. All values are free of NaN; colours and displacements are finite.
#ifndef STROBE_LAYER_GLSL
#define STROBE_LAYER_GLSL
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

// Texel of a layer.
struct Texel {
  vec3 color;   // linear, finite
  float depth;  // view depth, metres; +inf for the sky
  vec2 d;       // px over the exposure, at most limit * image width long
};

// Displacement from a texel of a velocity image, px over the exposure, finite and shortened to the limit (mixin/limit.glsl).
vec2 limited(vec4 texel) { return clampLength(finiteDisplacement(texel), limitPx()); }

// Texel of the layer at a pixel inside of the image.
Texel texelAt(ivec2 pixel) {
  vec2 d = limited(velocity_at(pixel));
  return Texel(finiteColor(color_at(pixel)), saneDepth(depth_at(pixel).x), d);
}

// True if the layer has a surface at the pixel.
bool isValid(ivec2 pixel) { return valid_at(pixel).x > 0.5; }

// True if the revealed layer has a surface behind the surface of this layer at the pixel.
bool hasBackground(ivec2 pixel) { return background_valid_at(pixel).x > 0.5; }

// View depth of the revealed layer at the pixel, metres; `otherwise` if the revealed layer has no surface there.
float backgroundDepth(ivec2 pixel, float otherwise) {
  return hasBackground(pixel) ? saneDepth(background_depth_at(pixel).x) : otherwise;
}

#endif
