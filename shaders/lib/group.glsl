// SPDX-License-Identifier: MIT
// Reductions over a tile of an image, for passes that write one texel per tile: one work group of 8x8 invocations reads a tile.
#ifndef STROBE_GROUP_GLSL
#define STROBE_GROUP_GLSL

const int kGroupSide = 8;

// First texel that this invocation reads in a tile that begins at the texel `first`. From there, the invocation reads every
// eighth texel along both axes.
ivec2 ownFirst(ivec2 first) { return first + ivec2(gl_LocalInvocationID.xy); }

// Index of a texel, in raster order, in a tile that begins at the texel `first` and is `width` texels wide.
uint placeInTile(ivec2 texel, ivec2 first, int width) {
  ivec2 within = texel - first;
  return uint(within.y * width + within.x);
}

shared uint group_greatest, group_first;

// True if this invocation has the greatest value of the work group. Among equal values, the invocation with the least `place`
// wins, so exactly one invocation gets true if the places of equal values differ. Values are at least 0. Contains barriers: all
// invocations must call the function.
bool isGreatest(float value, uint place) {
  if (gl_LocalInvocationIndex == 0u) {
    group_greatest = 0u;
    group_first = ~0u;
  }
  barrier();
  uint bits = floatBitsToUint(value);  // floats of at least 0 have the order of their bits
  atomicMax(group_greatest, bits);
  barrier();
  bool as_great = bits == group_greatest;
  if (as_great) atomicMin(group_first, place);
  barrier();
  bool first = as_great && place == group_first;
  barrier();
  return first;
}

#endif
