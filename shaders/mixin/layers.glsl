// SPDX-License-Identifier: MIT
// Needs: color_tex, params.limit, revealed_color_tex, revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex,
//   velocity_tex, velocity_post_tex, revealed_velocity_post_tex; may have: PARAM_trajectory, curve_tex, max_displacement_buf,
//   revealed_curve_tex, max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Access to the two layers of a composite. The raster layer has a surface (or the sky) at every pixel. The revealed layer has a
// surface only at pixels where a ray found one behind the raster layer. In the functions, `layer` is kRaster or kRevealed, and
// `after` selects the motion after the raster time instead of the motion before. The two differ only for motion in two
// segments.
#ifndef STROBE_LAYERS_GLSL
#define STROBE_LAYERS_GLSL
#include "mixin/path.glsl"
#include "lib/sanitise.glsl"

// Numbers of the layers; kNothing: no layer.
const int kNothing = 0, kRaster = 1, kRevealed = 2;

// True if the revealed layer has a surface at the pixel.
bool isRevealed(ivec2 pixel) { return revealed_valid_at(pixel).x > 0.5; }

// True if the texel is in the image and the layer has a surface there.
bool hasSurface(int layer, ivec2 texel) {
  return isInside(texel, textureSize(color_tex, 0)) && (layer == kRaster || isRevealed(texel));
}

// View depth of the revealed layer at a pixel where it has a surface, metres; +inf for the sky.
float revealedDepth(ivec2 pixel) { return saneDepth(revealed_depth_at(pixel).x); }

// Curve of the path of a texel (mixin/curve.glsl); 0 if the pass reads no curves.
vec4 curveAt(int layer, ivec2 pixel) {
#if HAS_curve
  return layer == kRaster ? curve_at(pixel) : revealed_curve_at(pixel);
#else
  return vec4(0);
#endif
}

// Displacement of a texel for the times after the raster time (`after`) or before, px over the exposure; not shortened.
vec4 displacementAt(int layer, ivec2 pixel, bool after) {
  if (layer == kRaster) return after ? velocity_post_at(pixel) : velocity_at(pixel);
  return after ? revealed_velocity_post_at(pixel) : revealed_velocity_at(pixel);
}

// Path of a texel: its displacement, shortened to the limit (mixin/limit.glsl), and its curve.
Path pathOf(int layer, ivec2 pixel, bool after) {
  return limitedPath(displacementAt(layer, pixel, after), curveAt(layer, pixel));
}

// Linear radiance of a texel at the raster time, finite.
vec3 colorOf(int layer, ivec2 texel) {
  if (layer == kRaster) return finiteColor(color_at(texel));
  return finiteColor(revealed_color_at(texel));
}

#endif
