// SPDX-License-Identifier: MIT
// Replaces unresolved samples by their fallback estimate at pixels without rays.
// In:  partial: sum of the resolved samples over the number of all samples, linear; alpha: share of resolved samples.
//      unresolved: unresolved samples, one bit each.
//      fallback_estimate: sum of the fallback estimates of unresolved samples over the number of all samples, linear.
//      mask: > 1/2 at pixels whose samples stay unresolved, for rays.
// Out: partial_now, unresolved_now: seen and open inside the mask; outside, seen + guess with alpha 1, and 0.
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
