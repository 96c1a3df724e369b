// SPDX-License-Identifier: MIT
// Path deviation of a layer, and marks for the surfaces that straight displacements do not describe.
// In:  `depth`: view depth, metres; +inf for the sky, 0 where the layer has no surface
//      `id`: instance + 1; 0 for the sky
//      `velocity`: displacement, px over the exposure
//      `hit`: instance + 1, geometry, primitive; absent: deformation by joints and morph targets is ignored
//      `normal`: unit normal in world space; absent: the stretch is not tested
// Out: `path_deviation`: position in the middle of the exposure minus the midpoint of the path's ends, px
//      `nonlinear`: 1 if `path_deviation` is longer than `max_deviation` px, or if a pixel stretches to more than `max_stretch`
//        px
// Method: pose the point at shutter open, in the middle of the exposure (the only time of the loop) and at shutter close. The
//   stretch of a pixel is the largest distance, at shutter open or close, of two points that are one pixel apart at the raster
//   time.
// Fails: a path that leaves its line and returns to the line by the middle of the exposure counts as straight.
#include "mixin/quantised.glsl"
#include "mixin/texel_path.glsl"

// Slices of the scene in the middle of the exposure, at shutter open and at shutter close.
const uint kSlices[3] = uint[3](SLICE_SAMPLE, SLICE_SHUTTER_OPEN, SLICE_SHUTTER_CLOSE);

// Path deviation of the surface at a texel, in the middle of the exposure, px. An end of the exposure at the raster time is
// skipped, because its offset from the raster time is 0.
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
