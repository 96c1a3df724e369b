// SPDX-License-Identifier: MIT
// Tint of moving pixels by the direction of their motion.
// In:  `color`:    linear radiance.
//      `velocity`: displacement, px over the exposure, x right, y down.
// Out: `tinted`:   linear radiance, alpha 1.
// Method: blend the colour with a hue, half of each. The channels of the hue are cosines of the angle, 120 degrees apart.
// Fails: slow and fast motion in one direction have the same tint.
void run(ivec2 pixel) {
  vec3 color = color_at(pixel).rgb;
  vec2 displacement = velocity_at(pixel).xy;
  if (displacement != vec2(0)) {
    float angle = atan(displacement.y, displacement.x);
    color = mix(color, 0.5 + 0.5 * cos(angle - radians(vec3(0, 120, 240))), 0.5);
  }
  imageStore(tinted_img, pixel, vec4(color, 1));
}
