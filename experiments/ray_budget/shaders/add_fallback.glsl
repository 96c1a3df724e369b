// SPDX-License-Identifier: MIT
// Completes the pixels without rays: adds the fallback estimate in place of their unresolved time samples.
// In:  partial: sum of the resolved samples, divided by the number of all samples, linear radiance; alpha: share of resolved
//               samples.
//      unresolved: bit i is set if time stratum i of at most 64 is unresolved.
//      fallback_estimate: sum of the fallback estimates of the unresolved samples, divided by the number of all samples, linear
//               radiance.
//      mask: > 1/2 at pixels with rays; a later pass traces their unresolved samples.
// Out: partial_now: colour of each pixel, complete at pixels without rays, linear radiance; alpha: share of resolved samples.
//      unresolved_now: unresolved samples that remain for rays, as in unresolved.
// Method: outside of the mask, if a sample is unresolved, partial_now = partial + fallback_estimate with alpha 1, and
//      unresolved_now = 0. All other pixels are copied.
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
