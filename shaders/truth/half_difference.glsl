// SPDX-License-Identifier: MIT
// Squared difference of the means of two halves of the samples, summed over blocks of pixels; first step of the test that stops
// the loop over samples (truth/stop.glsl).
// In:  `mean_a`, `mean_b`: rgb: mean linear radiance of each half of the samples; alpha: number of samples
// Out: `half_difference`: per block; x: sum of (mean a - mean b)^2 over the block's pixels and channels; y: number of pixels.
//        Both are 0 if a half has no sample in one of the pixels
// Method: sum over a square block with a side of `block` px. Blocks at the right and bottom border may be partial.
// Fails: never.
void run(ivec2 block) {
  ivec2 first = block * params.block;
  ivec2 end = min(first + params.block, textureSize(mean_a_tex, 0));
  float sum = 0.0;
  float pixels = 0.0;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      vec4 a = texelFetch(mean_a_tex, ivec2(x, y), 0);
      vec4 b = texelFetch(mean_b_tex, ivec2(x, y), 0);
      if (a.w == 0.0 || b.w == 0.0) {
        imageStore(half_difference_img, block, vec4(0));
        return;
      }
      vec3 difference = a.rgb - b.rgb;
      sum += dot(difference, difference);
      pixels += 1.0;
    }
  }
  imageStore(half_difference_img, block, vec4(sum, pixels, 0, 0));
}
