// SPDX-License-Identifier: MIT
// Running mean of the images that a loop makes, one per iteration.
// In:  `color`: linear radiance at one time of the exposure.
// Out: `mean`:  mean of the images so far, linear radiance; alpha 1. It is read and updated.
// Method: move the mean towards the image by 1/n in iteration n. The mean of equal images is that image, bit for bit.
// Fails: the mean is rounded in each iteration.
void run(ivec2 pixel) {
  vec3 mean = imageLoad(mean_img, pixel).rgb;
  mean += (color_at(pixel).rgb - mean) / float(frame.iteration + 1u);
  imageStore(mean_img, pixel, vec4(mean, 1));
}
