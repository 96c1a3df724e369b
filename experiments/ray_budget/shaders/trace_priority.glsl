// SPDX-License-Identifier: MIT
// Priority of pixels by the expected gain of rays at the sample times. Pixels that already have a ray are first: the budget
// counts pixels, so further rays there are free.
// In:  unresolved: unresolved samples, one bit each.
//      fallback_estimate: alpha: uncertainty of the fallback estimate, radiance.
//      mask: > 1/2 at pixels that already have a ray.
// Out: priority: priority of each pixel (lib/priority.glsl).
// Fails: the order is only as good as the uncertainty that fallback_estimate stores.
#include "lib/priority.glsl"

void run(ivec2 pixel) {
  uvec2 unresolved = texelFetch(unresolved_tex, pixel, 0).xy;
  uint priority = (unresolved.x | unresolved.y) != 0u ? rankOf(texelFetch(fallback_estimate_tex, pixel, 0).a) : 0u;
  if (texelFetch(mask_tex, pixel, 0).x > 0.5) priority = kFirstRank;
  imageStore(priority_img, pixel, uvec4(priority));
}
