// SPDX-License-Identifier: MIT
// Writes the list of the masked pixels, square by square in rows. Last of the three passes of the stream compaction, which
// turns a mask into a list of its pixels.
// In:  `bits`: masked pixels of each square of 8x8 pixels, one bit per pixel (lib/pixel_list.glsl).
//      `before`: per square, number of masked pixels in the earlier squares of its row.
//      `totals`: per row of squares, number of masked pixels.
// Out: `list`: the masked pixels, their number, and the number of work groups to dispatch over them (lib/compaction.glsl).
// Method: each square writes its pixels from the position (sum of `totals` of the earlier rows) + `before` of the square. The
//   positions depend on the mask alone, so that the order of the list is the same in every run.
// Fails: never.
#include "lib/compaction.glsl"
#include "lib/pixel_list.glsl"

// Number of masked pixels in the rows of squares before row `end`.
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
