// SPDX-License-Identifier: MIT
// Nearest triangle at each pixel's sample position, found by a ray instead of rasterisation.
// In:  none.
// Out: `hit`: instance + 1 (0 for the sky), geometry, primitive, 0; the format of the raster pass `visibility`.
// Method: trace the camera's ray at this pass's time (its `time` in the pipeline).
// Fails: never. Silhouettes may differ from the raster pass, which snaps vertices to 1/256 px.
#include "mixin/trace.glsl"

void run(ivec2 pixel) {
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  Hit hit = traceNearest(TIME_SLICE, ray, scene_cameras[TIME_SLICE].near, 3.0e38);
  imageStore(hit_img, pixel, isHit(hit) ? uvec4(hit.instance + 1u, hit.geometry, hit.primitive, 0u) : uvec4(0u));
}
