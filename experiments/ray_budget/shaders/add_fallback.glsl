// SPDX-License-Identifier: MIT
// Replaces unresolved samples by their fallback estimate at pixels without rays.
// In:  partial: sum of the resolved samples, divided by the number of all samples, linear; alpha: share of resolved samples.
//      unresolved: unresolved samples, one bit each.
//      fallback_estimate: sum of the fallback estimates of unresolved samples, divided by the number of all samples, linear.
//      mask: > 1/2 at pixels with rays, whose samples stay unresolved.
// Out: partial_now: partial inside the mask; outside, partial + fallback_estimate with alpha 1.
//      unresolved_now: unresolved inside the mask; 0 outside.
// Fails: inherits the errors of the fallback estimate.
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec4 partial = texelFetch(partial_tex, pixel, 0);
  uvec2 unresolved = texelFetch(unresolved_tex, pixel, 0).xy;
  bool stays = texelFetch(mask_tex, pixel, 0).x > 0.5;
  if (!stays && (unresolved.x | unresolved.y) != 0u) {
    partial = vec4(finiteColor(partial + texelFetch(fallback_estimate_tex, pixel, 0)), 1);
    unresolved = uvec2(0u);
  }
  imageStore(partial_now_img, pixel, partial);
  imageStore(unresolved_now_img, pixel, uvec4(unresolved, 0u, 0u));
}
