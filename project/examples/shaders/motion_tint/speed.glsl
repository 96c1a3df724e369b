// SPDX-License-Identifier: MIT
// Tint of moving pixels by their speed.
// In:  `color`:    linear radiance.
//      `velocity`: displacement, px over the exposure.
// Out: `tinted`:   linear radiance, alpha 1.
// Method: blend the colour with red. The share of red is the length of the displacement, divided by `limit`, at most 1.
// Fails: speeds above `limit` look alike.
void run(ivec2 pixel) {
  float share = min(length(velocity_at(pixel).xy) / params.limit, 1.0);
  imageStore(tinted_img, pixel, vec4(mix(color_at(pixel).rgb, vec3(1, 0, 0), share), 1));
}
