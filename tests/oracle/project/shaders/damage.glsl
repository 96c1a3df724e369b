// SPDX-License-Identifier: MIT
// In:  velocity (px over the exposure).
// Out: velocity: in the first eight columns (a, b), a undefined, infinite, minus infinite or 0, b 0 or 5.
void run(ivec2 pixel) {
  vec4 velocity = texelFetch(velocity_tex, pixel, 0);
  const uint firsts[4] = uint[4](0x7fc00000u, 0x7f800000u, 0xff800000u, 0u);
  if (pixel.x < 8) velocity = vec4(uintBitsToFloat(firsts[pixel.x / 2]), pixel.x % 2 == 0 ? 0.0 : 5.0, 0, 0);
  imageStore(velocity_img, pixel, velocity);
}
