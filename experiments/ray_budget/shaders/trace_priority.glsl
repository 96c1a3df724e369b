// SPDX-License-Identifier: MIT
// Ray priority of pixels with unresolved time samples: the expected gain of rays at the times of these samples.
// In:  unresolved: bit i is set if time stratum i of at most 64 is unresolved.
//      fallback_estimate: alpha: uncertainty of the estimate that is used without rays, linear radiance.
//      mask: > 1/2 at pixels that already have a ray, which reveals their background.
// Out: priority: ray priority of each pixel (lib/priority.glsl); 0 if the pixel has neither a ray nor unresolved samples.
// Method: the priority is the quantised uncertainty. Pixels of the mask have the highest priority, because the ray budget
//      counts pixels, so that further rays at such a pixel are free.
// Fails: the order is only as good as the uncertainty that fallback_estimate stores.
#include "lib/priority.glsl"

void run(ivec2 pixel) {
  uvec2 unresolved = texelFetch(unresolved_tex, pixel, 0).xy;
  uint priority = (unresolved.x | unresolved.y) != 0u ? rankOf(texelFetch(fallback_estimate_tex, pixel, 0).a) : 0u;
  if (texelFetch(mask_tex, pixel, 0).x > 0.5) priority = kFirstRank;
  imageStore(priority_img, pixel, uvec4(priority));
}
