// SPDX-License-Identifier: MIT
// Surfaces and colours of one step of the exposure, which the pass store_pose stored.
// In:  `poses`: per pixel and step, three indices of the surface and three floats of linear radiance
// Out: `hit`: instance + 1 (0 for the sky), geometry, primitive
//      `color`: linear radiance, alpha 1
// Method: read the six numbers of the current step.
// Fails: never.
void run(ivec2 pixel) {
  uint first = 48u * uint(pixel.y * pass_size().x + pixel.x) + 6u * frame.part;
  uvec3 hit;
  vec3 color;
  for (int k = 0; k < 3; ++k) {
    hit[k] = poses_buf.entries[first + uint(k)];
    color[k] = uintBitsToFloat(poses_buf.entries[first + 3u + uint(k)]);
  }
  imageStore(hit_img, pixel, uvec4(hit, 0u));
  imageStore(color_img, pixel, vec4(color, 1));
}
