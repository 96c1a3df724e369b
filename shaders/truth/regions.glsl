// SPDX-License-Identifier: MIT
// The regions errors are reported by, from what the time samples met (bits of lib/regions.glsl).
// In:  regions (bits, or-ed over all samples).  Out: inner, hidden, outer, self (1 inside of the region).
#include "lib/regions.glsl"

vec4 has(uint met, uint bit) { return vec4((met & bit) != 0u ? 1 : 0); }

void run(ivec2 pixel) {
  uint met = texelFetch(regions_tex, pixel, 0).x;
  imageStore(inner_img, pixel, has(met, kRegionInner));
  imageStore(hidden_img, pixel, has(met, kRegionHidden));
  imageStore(outer_img, pixel, has(met, kRegionOuter));
  imageStore(self_img, pixel, has(met, kRegionSelf));
}
