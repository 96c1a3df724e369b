// SPDX-License-Identifier: MIT
// Writes the list of the masked pixels, square by square in rows: last of the three passes of the stream compaction.
// In:  bits: masked pixels of each square of 8x8, one bit each (lib/pixel_list.glsl).
//      before: number of masked pixels in the squares before it in its row.
//      totals: number of masked pixels in each row of squares.
// Out: list: the pixels, their number, and the number of work groups for them (lib/compaction.glsl).
// Method: each square writes its pixels from the position (sum of the totals of earlier rows) + before. The positions are fixed
//   before the writes, so the order does not depend on the scheduling of invocations.
// Fails: never.
#include "lib/compaction.glsl"
#include "lib/pixel_list.glsl"

uint sumOfRows(int end) {
  uint sum = 0u;
  for (int row = 0; row < end; ++row) sum += totals_buf.entries[row];
  return sum;
}

void run(ivec2 square) {
  if (square == ivec2(0)) {
    list_buf.count = sumOfRows(pass_size().y);
    list_buf.groups = groupsOver(list_buf.count);
  }
  uvec2 bits = texelFetch(bits_tex, square, 0).xy;
  if (bits == uvec2(0u)) return;
  uint at = sumOfRows(square.y) + texelFetch(before_tex, square, 0).x;
  for (uint half_ = 0u; half_ < 2u; ++half_)
    for (uint left = bits[half_]; left != 0u; left &= left - 1u) {
      ivec2 place = pixelOf(half_ * 32u + uint(findLSB(left)));
      list_buf.entries[at++] = entryOf(square * kSquareSide + place);
    }
}
