// SPDX-License-Identifier: MIT
// The list of the masked pixels, square by square in rows. Each place is known before it is written: the order does not
// depend on which invocation comes first.
// In:  bits, before, totals.
// Out: list.
#include "lib/list.glsl"
#include "lib/listed.glsl"

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
      ivec2 place = listedPlace(half_ * 32u + uint(findLSB(left)));
      list_buf.entries[at++] = entryOf(square * kListedSide + place);
    }
}
