// SPDX-License-Identifier: MIT
// Stores the surfaces and colours of one step of the exposure.
// In:  `hit`: instance + 1 (0 for the sky), geometry, primitive
//      `color`: linear radiance
// Out: `poses`: updated in place; per pixel and step, the three indices and three floats of linear radiance
// Method: write the six numbers of the current step.
// Fails: never.
void run(ivec2 pixel) {
  uint first = 48u * uint(pixel.y * pass_size().x + pixel.x) + 6u * frame.part;
  for (int k = 0; k < 3; ++k) {
    poses_buf.entries[first + uint(k)] = texelFetch(hit_tex, pixel, 0)[k];
    poses_buf.entries[first + 3u + uint(k)] = floatBitsToUint(texelFetch(color_tex, pixel, 0)[k]);
  }
}
