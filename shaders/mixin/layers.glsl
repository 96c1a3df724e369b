// SPDX-License-Identifier: MIT
// Needs: color_tex, params.limit, revealed_color_tex, revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex,
//   velocity_tex, velocity_post_tex, revealed_velocity_post_tex; may have: PARAM_trajectory, curve_tex, max_displacement_buf,
//   revealed_curve_tex, max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// The two layers of a composite: the raster layer, which has a surface at every pixel, and the revealed layer, which has a
// surface where a ray found one.
#ifndef STROBE_LAYERS_GLSL
#define STROBE_LAYERS_GLSL
#include "mixin/path.glsl"
#include "lib/sanitise.glsl"

const int kNothing = 0, kRaster = 1, kRevealed = 2;

// True if the revealed layer has a surface at the pixel.
bool isRevealed(ivec2 pixel) { return revealed_valid_at(pixel).x > 0.5; }

// True if the texel is in the image and the layer has a surface there.
bool hasSurface(int layer, ivec2 texel) {
  return isInside(texel, textureSize(color_tex, 0)) && (layer == kRaster || isRevealed(texel));
}

// View depth of the revealed layer, metres.
float revealedDepth(ivec2 pixel) { return saneDepth(revealed_depth_at(pixel).x); }

// Curve of a texel's path (mixin/curve.glsl); 0 if the layer has no curves.
vec4 curveAt(int layer, ivec2 pixel) {
#if HAS_curve
  return layer == kRaster ? curve_at(pixel) : revealed_curve_at(pixel);
#else
  return vec4(0);
#endif
}

// Displacement of a texel for the times after the raster time (`after`) or before it, px over the exposure.
vec4 displacementAt(int layer, ivec2 pixel, bool after) {
  if (layer == kRaster) return after ? velocity_post_at(pixel) : velocity_at(pixel);
  return after ? revealed_velocity_post_at(pixel) : revealed_velocity_at(pixel);
}

Path pathOf(int layer, ivec2 pixel, bool after) {
  return limitedPath(displacementAt(layer, pixel, after), curveAt(layer, pixel));
}

vec3 colorOf(int layer, ivec2 now) {
  if (layer == kRaster) return finiteColor(color_at(now));
  return finiteColor(revealed_color_at(now));
}

#endif
