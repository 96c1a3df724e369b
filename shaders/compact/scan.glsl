// SPDX-License-Identifier: MIT
// Exclusive prefix sums of the masked pixels along each row of squares: second of the three passes of the stream compaction.
// In:  bits: masked pixels of each square of 8x8, one bit each (lib/pixel_list.glsl).
// Out: before: number of masked pixels in the squares before it in its row.
//      totals: number of masked pixels in each row of squares.
// Method: the first invocation of each row adds up the whole row.
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
