// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, max_displacement_buf, max_displacement_post_buf,
//   revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Screen path of a surface over the exposure: a displacement and, if the pass reads curves, the deviation from the straight
// line (mixin/curve.glsl). Passes without curves get straight paths and no extra arithmetic. Times t are in exposures from the
// raster time.
#ifndef STROBE_MIXIN_PATH_GLSL
#define STROBE_MIXIN_PATH_GLSL
#include "mixin/limit.glsl"
#include "mixin/curve.glsl"
#include "lib/sanitise.glsl"

#if HAS_curve
// Path in passes with curves.
struct Path {
  vec2 d;      // displacement, px over the exposure
  vec4 curve;  // 0: straight
};

// Path with a displacement, px over the exposure, and a curve.
Path onCurve(vec2 d, vec4 curve) { return Path(d, curve); }

// True if the path is not straight.
bool isCurved(Path path) { return path.curve != vec4(0); }

// Reach of a path, px: the length of its displacement. For a curved path: the length of a straight displacement that moves a
// surface at least as far.
float reachOf(Path path) { return reachOf(path.d, path.curve, frame.shutter); }

// Position at the raster time of the surface that is at the pixel at time t and has this path, relative to the pixel, px.
vec2 tapOffset(Path path, float t) { return -movedBy(path.d, path.curve, t, frame.shutter); }

// True if the surface that `texel` shows at the raster time and that has this path is at the pixel at time t, within the
// tolerance. The factor 1 + 1e-4 makes the result independent of rounding if the distance equals the tolerance.
bool isAt(ivec2 pixel, ivec2 texel, Path path, float t, float tolerance_px) {
  vec2 off = vec2(texel - pixel) + movedBy(path.d, path.curve, t, frame.shutter);
  float within_px = tolerance_px * (1.0 + 1e-4);
  return dot(off, off) <= within_px * within_px;
}
#else
// Path in passes without curves, and the functions above for straight paths.
struct Path {
  vec2 d;  // displacement, px over the exposure
};

// Straight path; `curve` is ignored.
Path onCurve(vec2 d, vec4 curve) { return Path(d); }

bool isCurved(Path path) { return false; }

float reachOf(Path path) { return lengthOf(path.d); }

vec2 tapOffset(Path path, float t) { return tapOffset(path.d, t); }

bool isAt(ivec2 pixel, ivec2 texel, Path path, float t, float tolerance_px) {
  return isAt(pixel, texel, path.d, t, tolerance_px);
}
#endif

// Straight path with the displacement d, px over the exposure.
Path straight(vec2 d) { return onCurve(d, vec4(0)); }

// Path from the texels of a velocity image (px over the exposure) and of a curve image. If the displacement is longer than the
// limit (mixin/limit.glsl), displacement and curve are scaled by one factor. A curve that is not finite becomes 0.
Path limitedPath(vec4 velocity, vec4 curve) {
  vec2 d = finiteDisplacement(velocity), shortened = clampLength(d, limitPx());
  if (any(isnan(curve)) || any(isinf(curve))) curve = vec4(0);
  if (shortened != d) curve = shortenedCurve(curve, lengthOf(shortened) / lengthOf(d));
  return onCurve(shortened, curve);
}

#endif
