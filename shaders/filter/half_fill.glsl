// SPDX-License-Identifier: MIT
// Fills in the pixels that a filter left out where it ran at half resolution, in some parts of the picture.
// In:  `blurred`: linear radiance; alpha 1. Pixels with even x and even y are never missing.
//      `mask`: above 1/2 at pixels that are not missing.
// Out: `filled`: linear radiance; alpha 1.
// Method: bilinear interpolation of the pixels with even coordinates: the mean of two neighbours, or of four where both
//   coordinates are odd. Beyond the border, the last pixel with an even coordinate is repeated.
// Fails: details of less than two pixels are lost in the missing pixels.
void run(ivec2 pixel) {
  if (mask_at(pixel).x > 0.5) {
    imageStore(filled_img, pixel, blurred_at(pixel));
    return;
  }
  ivec2 low = pixel & ~1, high = low + 2 * (pixel & 1);
  if (high.x >= pass_size().x) high.x = low.x;
  if (high.y >= pass_size().y) high.y = low.y;
  // Multiply before adding, so that sums of huge radiances stay finite.
  vec4 upper = 0.25 * blurred_at(low) + 0.25 * blurred_at(ivec2(high.x, low.y));
  vec4 lower = 0.25 * blurred_at(ivec2(low.x, high.y)) + 0.25 * blurred_at(high);
  imageStore(filled_img, pixel, upper + lower);
}
