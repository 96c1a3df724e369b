// SPDX-License-Identifier: MIT
// Mask of the pixels that get rays: the pixels with a priority above the threshold of the ray budget.
// In:  priority: ray priority of each pixel (lib/priority.glsl).
//      limit: threshold from priority_limit.glsl, one texel.
// Out: mask: 1 at pixels with priority > limit, otherwise 0.
// Method: compare the priority with the threshold, which is at least 0, so that pixels of priority 0 are never selected.
// Fails: does not fail.
void run(ivec2 pixel) {
  bool ahead = texelFetch(priority_tex, pixel, 0).x > texelFetch(limit_tex, ivec2(0), 0).x;
  imageStore(mask_img, pixel, vec4(ahead ? 1 : 0));
}
