// SPDX-License-Identifier: MIT
// Exclusive prefix sums of the numbers of masked pixels, along each row of squares. Second of the three passes of the stream
// compaction, which turns a mask into a list of its pixels.
// In:  `bits`: masked pixels of each square of 8x8 pixels, one bit per pixel (lib/pixel_list.glsl).
// Out: `before`: per square, number of masked pixels in the earlier squares of its row.
//      `totals`: per row of squares, number of masked pixels.
// Method: the invocation of the first square of each row adds up the whole row.
// Fails: never.
#include "lib/pixel_list.glsl"

void run(ivec2 square) {
  if (square.x > 0) return;
  uint sum = 0u;
  for (ivec2 at = square; at.x < pass_size().x; ++at.x) {
    imageStore(before_img, at, uvec4(sum));
    sum += pixelCount(texelFetch(bits_tex, at, 0).xy);
  }
  totals_buf.entries[square.y] = sum;
}
