// SPDX-License-Identifier: MIT
// Lists: buffers whose entries are the pixels that a pass runs for.
#ifndef STROBE_LIST_GLSL
#define STROBE_LIST_GLSL

// Of a pixel, sides below 2^16.
uint entryOf(ivec2 pixel) { return uint(pixel.x) | uint(pixel.y) << 16; }

// Groups of 64 invocations for so many entries, in rows of at most 2^15.
uvec3 groupsOver(uint count) {
  uint groups = (count + 63u) / 64u, rows = (groups + 32767u) / 32768u;
  return uvec3(rows > 1u ? 32768u : groups, rows, 1u);
}

#endif
