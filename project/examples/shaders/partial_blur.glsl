// SPDX-License-Identifier: MIT
// Blend of a sharp and a blurred picture.
// In:  `sharp`, `blurred`: linear radiance.
//      `mask`:  above 1/2 where the blur is kept; absent: everywhere.
// Out: `color`: linear radiance, alpha 1.
// Method: blend the pictures. The weight of the blurred picture is `strength`, and 0 outside of the mask.
// Fails: the sharp silhouette of a moving object stays visible within its blur.
void run(ivec2 pixel) {
  bool is_kept = mask_at(pixel).x > 0.5;
  if (!is_kept) count_masked(1u);
  float strength = is_kept ? params.strength : 0.0;
  imageStore(color_img, pixel, vec4(mix(sharp_at(pixel).rgb, blurred_at(pixel).rgb, strength), 1));
}
