// SPDX-License-Identifier: MIT
// Out: distance, of the pixels of `listed`.
#include "mixin/trace.glsl"

void run(ivec2 pixel) {
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
  Hit hit = traceNearest(SLICE_CAPTURE, ray, scene_cameras[SLICE_CAPTURE].near, 3.0e38);
  imageStore(distance_img, pixel, vec4(isHit(hit) ? hit.t : -1.0));
}
