// SPDX-License-Identifier: MIT
// Pixel lists: buffers with the pixels of a mask. A pass can be dispatched over the entries of a list instead of over the
// image.
#ifndef STROBE_COMPACTION_GLSL
#define STROBE_COMPACTION_GLSL

// List entry of a pixel: x in the lower 16 bits, y in the upper 16 bits. The sides of an image are below 2^16 px.
uint entryOf(ivec2 pixel) { return uint(pixel.x) | uint(pixel.y) << 16; }

// Numbers of work groups for a dispatch of 64 invocations per group over `count` entries, in rows of at most 2^15 groups.
uvec3 groupsOver(uint count) {
  uint groups = (count + 63u) / 64u, rows = (groups + 32767u) / 32768u;
  return uvec3(rows > 1u ? 32768u : groups, rows, 1u);
}

#endif
