// SPDX-License-Identifier: MIT
// Mask of the pixels whose priority is above a threshold.
// In:  priority: priority of each pixel (lib/priority.glsl).
//      limit: threshold, one texel.
// Out: mask: 1 at pixels with priority > limit, otherwise 0. Pixels of priority 0 are never selected.
// Fails: does not fail.
void run(ivec2 pixel) {
  bool ahead = texelFetch(priority_tex, pixel, 0).x > texelFetch(limit_tex, ivec2(0), 0).x;
  imageStore(mask_img, pixel, vec4(ahead ? 1 : 0));
}
