// SPDX-License-Identifier: MIT
// Out: distance, of the pixels of `listed`.
#include "mixin/trace.glsl"

void run(ivec2 pixel) {
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
  Hit hit = traceNearest(SLICE_RASTER, ray, scene_cameras[SLICE_RASTER].near, 3.0e38);
  imageStore(distance_img, pixel, vec4(isHit(hit) ? hit.t : -1.0));
}
