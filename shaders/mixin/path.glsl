// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, dominant_curve_tex, max_displacement_buf.
// Screen path of a surface: a displacement and, if the pass reads curves, the deviation from the straight line
// (mixin/curve.glsl). Without curves, paths are straight lines and cost no extra arithmetic.
#ifndef STROBE_MIXIN_PATH_GLSL
#define STROBE_MIXIN_PATH_GLSL
#include "mixin/limit.glsl"
#include "mixin/curve.glsl"
#include "lib/sanitise.glsl"

struct Path {
  vec2 d;  // px over the exposure
#if HAS_curve
  vec4 curve;
#endif
};

Path onCurve(vec2 d, vec4 curve) {
#if HAS_curve
  return Path(d, curve);
#else
  return Path(d);
#endif
}

Path straight(vec2 d) { return onCurve(d, vec4(0)); }

bool isCurved(Path path) {
#if HAS_curve
  return path.curve != vec4(0);
#else
  return false;
#endif
}

// Path from values of images, shortened to the limit. The curve is scaled alike; a curve that is not finite becomes 0.
Path limitedPath(vec4 velocity, vec4 curve) {
  vec2 d = finiteDisplacement(velocity), shortened = clampLength(d, limitPx());
#if HAS_curve
  if (any(isnan(curve)) || any(isinf(curve))) curve = vec4(0);
  if (shortened != d) curve = shortenedCurve(curve, lengthOf(shortened) / lengthOf(d));
#endif
  return onCurve(shortened, curve);
}

// Reach of a path, px: length of its displacement or, if curved, of a straight displacement that reaches as far.
float reachOf(Path path) {
#if HAS_curve
  return reachOf(path.d, path.curve, frame.shutter);
#else
  return lengthOf(path.d);
#endif
}

// Path of a tile's dominant displacement.
Path dominantPath(vec2 d, ivec2 tile) {
#if HAS_curve && HAS_dominant_curve
  return onCurve(d, texelFetch(dominant_curve_tex, tile, 0));
#else
  return straight(d);
#endif
}

// Position at the raster time, relative to the pixel, of the surface that is at the pixel at time t.
vec2 tapOffset(Path path, float t) {
#if HAS_curve
  return -movedBy(path.d, path.curve, t, frame.shutter);
#else
  return tapOffset(path.d, t);
#endif
}

// True if the surface at the texel `now` at the raster time is at the pixel at time t, within the tolerance.
bool isAt(ivec2 pixel, ivec2 now, Path path, float t, float tolerance_px) {
#if HAS_curve
  vec2 off = vec2(now - pixel) + movedBy(path.d, path.curve, t, frame.shutter);
  float within_px = tolerance_px * (1.0 + 1e-4);
  return dot(off, off) <= within_px * within_px;
#else
  return isAt(pixel, now, path.d, t, tolerance_px);
#endif
}

#endif
