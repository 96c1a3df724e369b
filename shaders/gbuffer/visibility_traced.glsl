// SPDX-License-Identifier: MIT
// Nearest triangle at each pixel's sample position, by a ray.
// In:  none
// Out: `hit`: instance + 1 (0 = sky), geometry, primitive, 0, as the raster pass `visibility` writes it
// Method: trace the camera's ray at the node's time.
// Fails: never; silhouettes may differ from raster, which snaps vertices to 1/256 px.
#include "mixin/trace.glsl"

void run(ivec2 pixel) {
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  Hit hit = traceNearest(TIME_SLICE, ray, scene_cameras[TIME_SLICE].near, 3.0e38);
  imageStore(hit_img, pixel, isHit(hit) ? uvec4(hit.instance + 1u, hit.geometry, hit.primitive, 0u) : uvec4(0u));
}
