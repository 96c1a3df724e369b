// SPDX-License-Identifier: MIT
// Where each square's pixels begin, in its row of squares; the first invocation of a row does it all.
// In:  bits.
// Out: before (of each square, the pixels of its row in front of it), totals (an entry for each row).
#include "lib/listed.glsl"

void run(ivec2 square) {
  if (square.x > 0) return;
  uint sum = 0u;
  for (ivec2 at = square; at.x < pass_size().x; ++at.x) {
    imageStore(before_img, at, uvec4(sum));
    sum += listedCount(texelFetch(bits_tex, at, 0).xy);
  }
  totals_buf.entries[square.y] = sum;
}
