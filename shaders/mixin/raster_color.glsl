// SPDX-License-Identifier: MIT
// Needs: PARAM_shades_contrast, count_shaded, depth_tex, id_tex, params.detail_below, params.same_depth, params.contrast, rays,
//   scene; may have: PARAM_displacement, color_tex, revealed_color_tex, revealed_depth_tex, revealed_id_tex,
//   revealed_valid_tex.
// Colour at the raster time of a surface point that a ray hits at another time.
// Method: if a layer shows the point at the raster time, interpolate the layer's colour bilinearly from the four nearest
//   texels, leaving out texels that show another surface. Otherwise shade the point. With `shades_contrast`, the layer is used
//   only in two cases: all four texels show the surface and differ by at most the share `contrast`, or the surface moves by
//   more than `detail_below` px between two samples.
#ifndef STROBE_RASTER_COLOR_GLSL
#define STROBE_RASTER_COLOR_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "lib/color_range.glsl"
#include "mixin/shade.glsl"

// True if the texel `at` of the raster layer shows the surface `id` (instance + 1, geometry + 1) at the view depth `depth`,
// metres. Depths may differ by the share `same_depth`.
bool isShown(ivec2 at, uvec2 id, float depth) {
  return texelFetch(id_tex, at, 0).xy == id && relativeGap(texelFetch(depth_tex, at, 0).x, depth) <= params.same_depth;
}

// True if the texel `at` of the revealed layer shows the surface `id` at the view depth `depth`, as in `isShown`. False if the
// pass does not read the revealed layer.
bool isRevealed(ivec2 at, uvec2 id, float depth) {
#if HAS_revealed_valid
  return texelFetch(revealed_valid_tex, at, 0).x > 0.5 && texelFetch(revealed_id_tex, at, 0).xy == id &&
         relativeGap(texelFetch(revealed_depth_tex, at, 0).x, depth) <= params.same_depth;
#else
  return false;
#endif
}

// Linear radiance of a texel, finite: of the raster layer if `is_shown` is true, otherwise of the revealed layer.
vec3 texelOf(ivec2 at, bool is_shown) {
#if HAS_revealed_valid
  return finiteColor(is_shown ? texelFetch(color_tex, at, 0) : texelFetch(revealed_color_tex, at, 0));
#else
  return finiteColor(texelFetch(color_tex, at, 0));
#endif
}

// Distance that a surface point moves on the screen between two successive samples, px: its displacement divided by the number
// of samples. Not valid for points behind the near plane at an end of the exposure.
float spacingOf(Hit hit) {
  vec3 open_vs = viewFromWorld(SLICE_SHUTTER_OPEN, positionOf(SLICE_SHUTTER_OPEN, hit));
  vec3 close_vs = viewFromWorld(SLICE_SHUTTER_CLOSE, positionOf(SLICE_SHUTTER_CLOSE, hit));
  return lengthOf(pixelFromView(SLICE_SHUTTER_CLOSE, close_vs) - pixelFromView(SLICE_SHUTTER_OPEN, open_vs)) /
         float(frame.slice_count * frame.iteration_count);
}

// Linear radiance of the hit point as at the raster time, from a layer or by shading (counter `shaded`). Texels with a bilinear
// weight below 1e-3 are skipped.
vec3 rasterColorOf(Hit hit) {
  vec3 place;
  if (!placeInRaster(hit, place)) place.xy = vec2(-2);
  vec2 low = clamp(floor(place.xy), vec2(-2), vec2(frame.size) + 1.0), share = place.xy - low;
  uvec2 id = uvec2(hit.instance, hit.geometry) + 1u;
  vec3 sum = vec3(0);
  float weights = 0.0;
  bool all_shown = true;
  ColorRange color_range = emptyColorRange();
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1), at = ivec2(low) + corner;
    vec2 part = mix(1.0 - share, share, equal(corner, ivec2(1)));
    float weight = part.x * part.y;
    if (weight < 1e-3) continue;
    bool inside = isInside(at, ivec2(frame.size)), is_shown = inside && isShown(at, id, place.z);
    if (!is_shown && !(inside && isRevealed(at, id, place.z))) {
      all_shown = false;
      continue;
    }
    vec3 color = texelOf(at, is_shown);
    color_range = withColor(color_range, color);
    sum += weight * toSum(color);
    weights += weight;
  }
#if PARAM_shades_contrast
  if ((!all_shown || !isNarrow(color_range, params.contrast)) && !(spacingOf(hit) > params.detail_below)) weights = 0.0;
#endif
  if (weights > 0.0)
    return isNarrow(color_range, 0.0) ? color_range.low : fromSum(sum / weights);  // equal colours: no rounding
  count_shaded(1u);
  return shade(SLICE_RASTER, hit);
}

#endif
