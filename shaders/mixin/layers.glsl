// SPDX-License-Identifier: MIT
// Needs: color_tex, params.limit, revealed_color_tex, revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex,
//   velocity_tex; may have: PARAM_trajectory, velocity_post_tex, curve_tex, dominant_curve_tex, max_displacement_buf,
//   revealed_velocity_post_tex, revealed_curve_tex.
// The two layers of a composite: the raster layer, which has a surface at every pixel, and the revealed layer, which has a
// surface where a ray found one.
#ifndef STROBE_LAYERS_GLSL
#define STROBE_LAYERS_GLSL
#include "mixin/path.glsl"
#include "lib/sanitise.glsl"

const int kNothing = 0, kRaster = 1, kRevealed = 2;

// True if the revealed layer has a surface at the pixel.
bool isRevealed(ivec2 pixel) { return texelFetch(revealed_valid_tex, pixel, 0).x > 0.5; }

// True if the texel is in the image and the layer has a surface there.
bool hasSurface(int layer, ivec2 texel) {
  return isInside(texel, textureSize(color_tex, 0)) && (layer == kRaster || isRevealed(texel));
}

// View depth of the revealed layer, metres.
float revealedDepth(ivec2 pixel) { return saneDepth(texelFetch(revealed_depth_tex, pixel, 0).x); }

// Curve of a texel's path (mixin/curve.glsl); 0 if the layer has no curves.
vec4 curveAt(int layer, ivec2 pixel) {
#if HAS_curve
  if (layer == kRaster) return texelFetch(curve_tex, pixel, 0);
#endif
#if HAS_revealed_curve
  if (layer == kRevealed) return texelFetch(revealed_curve_tex, pixel, 0);
#endif
  return vec4(0);
}

// Raster layer's displacement for the times after the raster time (`after`) or before it, px over the exposure.
vec4 displacementAt(ivec2 pixel, bool after) {
#if HAS_velocity_post
  if (after) return texelFetch(velocity_post_tex, pixel, 0);
#endif
  return texelFetch(velocity_tex, pixel, 0);
}

// Displacement of the revealed layer for the times after or before the raster time, px over the exposure.
vec4 revealedDisplacementAt(ivec2 pixel, bool after) {
#if HAS_revealed_velocity_post
  if (after) return texelFetch(revealed_velocity_post_tex, pixel, 0);
#endif
  return texelFetch(revealed_velocity_tex, pixel, 0);
}

Path pathOf(int layer, ivec2 pixel, bool after) {
  vec4 d = layer == kRaster ? displacementAt(pixel, after) : revealedDisplacementAt(pixel, after);
  return limitedPath(d, curveAt(layer, pixel));
}

vec3 colorOf(int layer, ivec2 now) {
  if (layer == kRaster) return finiteColor(texelFetch(color_tex, now, 0));
  return finiteColor(texelFetch(revealed_color_tex, now, 0));
}

#endif
