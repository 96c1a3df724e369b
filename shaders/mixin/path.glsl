// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, max_displacement_buf, max_displacement_post_buf,
//   revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Screen path of a surface: a displacement and, if the pass reads curves, the deviation from the straight line
// (mixin/curve.glsl). Without curves, paths are straight lines and cost no extra arithmetic.
#ifndef STROBE_MIXIN_PATH_GLSL
#define STROBE_MIXIN_PATH_GLSL
#include "mixin/limit.glsl"
#include "mixin/curve.glsl"
#include "lib/sanitise.glsl"

#if HAS_curve
struct Path {
  vec2 d;  // px over the exposure
  vec4 curve;
};

Path onCurve(vec2 d, vec4 curve) { return Path(d, curve); }

bool isCurved(Path path) { return path.curve != vec4(0); }

// Reach of a path, px: length of its displacement. For a curved path: length of a straight displacement that moves a surface at
// least as far.
float reachOf(Path path) { return reachOf(path.d, path.curve, frame.shutter); }

// Position at the raster time, relative to the pixel, of the surface that is at the pixel at time t.
vec2 tapOffset(Path path, float t) { return -movedBy(path.d, path.curve, t, frame.shutter); }

// True if the surface at the texel `now` at the raster time is at the pixel at time t, within the tolerance.
bool isAt(ivec2 pixel, ivec2 now, Path path, float t, float tolerance_px) {
  vec2 off = vec2(now - pixel) + movedBy(path.d, path.curve, t, frame.shutter);
  float within_px = tolerance_px * (1.0 + 1e-4);
  return dot(off, off) <= within_px * within_px;
}
#else
struct Path {
  vec2 d;  // px over the exposure
};

Path onCurve(vec2 d, vec4 curve) { return Path(d); }

bool isCurved(Path path) { return false; }

float reachOf(Path path) { return lengthOf(path.d); }

vec2 tapOffset(Path path, float t) { return tapOffset(path.d, t); }

bool isAt(ivec2 pixel, ivec2 now, Path path, float t, float tolerance_px) {
  return isAt(pixel, now, path.d, t, tolerance_px);
}
#endif

Path straight(vec2 d) { return onCurve(d, vec4(0)); }

// Path of a texel from the values of the images. If the displacement is longer than the limit (mixin/limit.glsl), displacement
// and curve are scaled by the same factor. A curve that is not finite becomes 0.
Path limitedPath(vec4 velocity, vec4 curve) {
  vec2 d = finiteDisplacement(velocity), shortened = clampLength(d, limitPx());
  if (any(isnan(curve)) || any(isinf(curve))) curve = vec4(0);
  if (shortened != d) curve = shortenedCurve(curve, lengthOf(shortened) / lengthOf(d));
  return onCurve(shortened, curve);
}

#endif
