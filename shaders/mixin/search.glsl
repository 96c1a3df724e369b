// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, max_displacement_buf, max_displacement_post_buf,
//   revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Iterative search in a layer for the texel of the raster time that shows the surface at a pixel at time t. A search tests a
// start texel. If the texel's surface is not at the pixel at time t, the texel's own path gives the next texel to test. The
// search thus handles motion that varies over a surface (perspective, rotation). A texel counts as found only if `isAt` is true
// for it, so a poor start texel may lead to no result, but not to a wrong result.
#ifndef STROBE_SEARCH_GLSL
#define STROBE_SEARCH_GLSL
#include "mixin/path.glsl"

// Position that stands for an unknown texel.
const ivec2 kNoTexel = ivec2(-1);

// Number of texels that a search tests at most, on straight and on curved paths. Passes without curves always test at most two,
// because compilers unroll a loop over two texels. On seven scenes with arcs, two texels instead of four on curved paths raise
// the error by up to 42 %, and eight texels change the error by at most 0.1 %. On seven scenes with straight paths, one
// texel instead of two changes the error by -7 % to +33 %, and four texels by -8 % to +1 %.
#if HAS_curve
const int kIterations = 2, kCurveIterations = 4;
#else
const int kIterations = 2, kCurveIterations = kIterations;
#endif

// True if the search tests another texel after texel number i, counted from 0. `path`: path of texel i.
bool iteratesAgain(int i, Path path) { return i + 1 < (isCurved(path) ? kCurveIterations : kIterations); }

// Largest difference between the paths of adjacent texels of one surface, px. If the paths differ more, the texels are assumed
// to show different objects. On seven scenes, halving or doubling this bound changes the error of arcs by at most
// 0.4 %; the error of parabolas rises by up to 10 % at half the value and 3 % at twice the value.
const float kMostSlope = 2.0;

// Two functions that the including shader defines. `pathOf`: path of the surface at a texel of a layer, for the times after the
// raster time if `after` is true, otherwise for the times before it. `hasSurface`: true if the layer has a surface at the
// texel.
Path pathOf(int layer, ivec2 texel, bool after);
bool hasSurface(int layer, ivec2 texel);

// Texel at the raster time of a surface that is at the pixel at time t and has this path. The texel may be outside of the
// image.
ivec2 nextTexel(ivec2 pixel, Path path, float t) { return pixel + roundSymmetric(tapOffset(path, t)); }

#if HAS_curve
// Slope: difference of the tap offsets (`tapOffset`, at time t) of two adjacent texels along an axis, px. The slope at
// a texel is unknown if both of its neighbours along the axis belong to other objects.
struct Slope {
  vec2 px;
  bool is_known;
};

// Slope at `texel` along `axis`, (1, 0) or (0, 1). `path`: path at `texel`. The slope is taken to the first of the two
// neighbours that is on the same object. A neighbour counts as on the same object if its tap offset and its
// displacement differ by at most kMostSlope from the tap offset and the displacement of `texel`.
Slope slopeOf(int layer, ivec2 texel, ivec2 axis, Path path, float t) {
  vec2 offset = tapOffset(path, t);
  for (int side = 1; side >= -1; side -= 2) {
    ivec2 at = texel + side * axis;
    if (!hasSurface(layer, at)) continue;
    Path beside = pathOf(layer, at, t > 0.0);
    vec2 slope = tapOffset(beside, t) - offset, over_all = beside.d - path.d;
    if (max(dot(slope, slope), dot(over_all, over_all)) <= kMostSlope * kMostSlope) return Slope(float(side) * slope, true);
  }
  return Slope(vec2(0), false);
}

// Derivative of a surface point's screen position at time t with respect to its texel at the raster time. At corners of an
// object, the slope along one axis is unknown. The motion is then assumed to be a rotation with a uniform scale. Without this
// assumption, a Newton step from a distant texel would go far off.
mat2 changeOf(int layer, ivec2 texel, Path path, float t) {
  Slope x = slopeOf(layer, texel, ivec2(1, 0), path, t), y = slopeOf(layer, texel, ivec2(0, 1), path, t);
  if (!x.is_known) x.px = vec2(y.px.y, -y.px.x);
  if (!y.is_known) y.px = vec2(-x.px.y, x.px.x);
  return mat2(vec2(1, 0) - x.px, vec2(0, 1) - y.px);
}
#endif

// Next texel to test, if the surface at `texel` of a layer is not at the pixel at time t. `path`: path of that surface.
// Method: on a straight path, take a step of fixed-point iteration: follow `path` from the pixel back to the raster time. On a
//   curved path, take a Newton step: a surface with curved paths usually rotates, so that paths differ from texel to
//   texel. A Newton step needs the derivative of the position at time t with respect to the texel. For an arc that
//   rotates, the derivative follows from the arc. Otherwise it is estimated from the paths of adjacent texels
//   (`changeOf`). One Newton step suffices if the whole surface rotates or stretches uniformly. If the derivative is
//   nearly singular (determinant below 0.1), take a fixed-point step instead. Halving or doubling this bound changes
//   the error by at most 0.2 % on seven scenes.
ivec2 nextTexelOf(int layer, ivec2 pixel, ivec2 texel, Path path, float t) {
#if HAS_curve
  if (!isCurved(path)) return nextTexel(pixel, path, t);
  vec2 offset = tapOffset(path, t);
  vec2 off = vec2(texel - pixel) - offset;
#if ON_ARCS
  if (isTurning(path.curve)) return ivec2(round(vec2(texel) - complexQuotient(off, complexExp(t * path.curve.zw))));
#endif
  mat2 change = changeOf(layer, texel, path, t);
  if (abs(determinant(change)) >= 0.1) return ivec2(round(vec2(texel) - inverse(change) * off));
#endif
  return nextTexel(pixel, path, t);
}

#endif
