// SPDX-License-Identifier: MIT
// Path deviation of a layer: marks surfaces that straight displacements do not describe.
// In:  `depth`:    view depth, m; +inf for the sky, 0 where the layer has no surface
//      `id`:       instance + 1; 0 for the sky
//      `velocity`: px over the exposure
//      `hit`:      instance + 1, geometry, primitive; absent: surfaces are rigid
//      `normal`:   unit, world; absent: growth is not tested
// Out: `bend`:     path deviation, px: position in the middle of the exposure minus the midpoint of the path's ends
//      `bent`:     1 if `bend` is longer than `most_bend` px, or if a pixel grows to more than `most_growth` px
// Method: pose the point at shutter open, in the middle and at shutter close (a loop with one time, the middle). A pixel's
//      growth is the largest distance, at either end, between two points that were one pixel apart at the raster time.
// Fails: a path that leaves its line and returns within half of the exposure counts as straight.
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"

// Middle of the exposure, shutter open, shutter close.
const uint kSlices[3] = uint[3](SLICE_SAMPLE, SLICE_OPEN, SLICE_CLOSE);

// Path deviation of the surface at a texel, in the middle of the exposure, px. An end at the raster time adds 0.
vec2 bendAt(ivec2 pixel) {
  vec2 bend = vec2(0);
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && frame.shutter[k - 1] == 0.0) continue;
    vec2 path = pathOfTexel(kSlices[k], pixel);
    if (k == 0) bend = path;
    else bend -= 0.5 * path;
  }
  return bend;
}

void run(ivec2 pixel) {
  if (!isMoving(pixel)) return;
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec2 bend = (kind & PATH_CURVED) != 0u ? bendAt(pixel) : vec2(0);
  bool grows = (kind & PATH_TURNS) != 0u && growsAt(pixel, id);
  if (bend != vec2(0)) imageStore(bend_img, pixel, vec4(storedVelocity(bend), 0, 0));
  if (!(lengthOf(bend) <= params.most_bend) || grows) imageStore(bent_img, pixel, vec4(1));
}
