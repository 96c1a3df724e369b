// SPDX-License-Identifier: MIT
// Path deviation of a layer: marks surfaces that straight displacements do not describe.
// In:  `depth`:    view depth, m; +inf for the sky, 0 where the layer has no surface
//      `id`:       instance + 1; 0 for the sky
//      `velocity`: px over the exposure
//      `hit`:      instance + 1, geometry, primitive; absent: surfaces are rigid
//      `normal`:   unit, world; absent: growth is not tested
// Out: `path_deviation`:     path deviation, px: position in the middle of the exposure minus the midpoint of the path's ends
//      `nonlinear`:     1 if `path_deviation` is longer than `max_deviation` px, or if a pixel grows to more than `max_stretch`
//        px
// Method: pose the point at shutter open, in the middle and at shutter close (a loop with one time, the middle). A pixel's
//      growth is the largest distance, at either end, between two points that were one pixel apart at the raster time.
// Fails: a path that leaves its line and returns within half of the exposure counts as straight.
#include "mixin/quantised.glsl"
#include "mixin/texel_path.glsl"

// Middle of the exposure, shutter open, shutter close.
const uint kSlices[3] = uint[3](SLICE_SAMPLE, SLICE_SHUTTER_OPEN, SLICE_SHUTTER_CLOSE);

// Path deviation of the surface at a texel, in the middle of the exposure, px. An end at the raster time adds 0.
vec2 deviationAt(ivec2 pixel) {
  vec2 path_deviation = vec2(0);
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && frame.shutter[k - 1] == 0.0) continue;
    vec2 path = pathOfTexel(kSlices[k], pixel);
    if (k == 0) path_deviation = path;
    else path_deviation -= 0.5 * path;
  }
  return path_deviation;
}

void run(ivec2 pixel) {
  if (!isMoving(pixel)) return;
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec2 path_deviation = (kind & PATH_CURVED) != 0u ? deviationAt(pixel) : vec2(0);
  bool grows = (kind & PATH_TURNS) != 0u && growsAt(pixel, id);
  if (path_deviation != vec2(0)) imageStore(path_deviation_img, pixel, vec4(quantisedVelocity(path_deviation), 0, 0));
  if (!(lengthOf(path_deviation) <= params.max_deviation) || grows) imageStore(nonlinear_img, pixel, vec4(1));
}
