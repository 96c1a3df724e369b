// SPDX-License-Identifier: MIT
// Stops the loop over time samples when the standard error of their mean is small enough.
// In:  `half_difference`: per block: x: sum of the squared differences of the two halves' means; y: number of pixels, 0 if the
//        difference is unknown
// Out: `stop`: one pixel: 1 if at least `min_samples` iterations have run and the standard error is at most `tolerance`,
//        otherwise 0
// Method: standard error = rms(mean a - mean b) / 2, where mean a and mean b are the means of the two halves, and rms is the
//   root of the mean square over all pixels and channels.
// Fails: two halves that agree by chance stop the loop too early; `min_samples` makes this unlikely.
void run(ivec2 pixel) {
  ivec2 size = textureSize(half_difference_tex, 0);
  float sum = 0.0;
  float pixels = 0.0;
  bool known = true;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      vec4 block = texelFetch(half_difference_tex, ivec2(x, y), 0);
      known = known && block.y > 0.0;
      sum += block.x;
      pixels += block.y;
    }
  }
  bool enough = known && int(frame.iteration) + 1 >= params.min_samples;
  float error = 0.5 * sqrt(sum / max(3.0 * pixels, 1.0));
  imageStore(stop_img, pixel, vec4(enough && error <= params.tolerance ? 1 : 0));
}
