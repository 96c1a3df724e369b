// SPDX-License-Identifier: MIT
// Where a layer's straight displacements say too little: how far paths are from straight lines, at the middle of the exposure
// from the middle between their ends, and by how much more of the picture a surface covers at the ends than at the capture.
// In a loop whose one time is the middle.
// In:  depth (view depth, m, sky +inf, 0 where the layer has nothing), id (instance + 1, 0 = sky), velocity (px over the
//      exposure), hit (geometry and primitive; absent: surfaces are rigid), normal (unit, world; absent: growth is not
//      looked at).
// Out: bend (how far, px), bent (1 where it is more than `most_bend` px, or a pixel grows to more than `most_growth`
//      px).
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"

// The middle of the exposure, and its ends.
const uint kSlices[3] = uint[3](SLICE_SAMPLE, SLICE_OPEN, SLICE_CLOSE);

// How far the path of what a texel shows is from the line between its ends, in its middle.
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
