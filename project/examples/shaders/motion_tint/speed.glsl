// SPDX-License-Identifier: MIT
// Tint of moving pixels by their speed.
// In:  `color`:    linear radiance.
//      `velocity`: displacement, px over the exposure.
// Out: `tinted`:   linear radiance, alpha 1.
// Method: blend to red by the length of the displacement, up to `limit`.
// Fails: speeds above the limit look alike.
void run(ivec2 pixel) {
  float share = min(length(velocity_at(pixel).xy) / params.limit, 1.0);
  imageStore(tinted_img, pixel, vec4(mix(color_at(pixel).rgb, vec3(1, 0, 0), share), 1));
}
