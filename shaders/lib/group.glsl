// SPDX-License-Identifier: MIT
// Of a pass that has a work group for each pixel: 8x8 invocations, which look at a tile together.
#ifndef STROBE_GROUP_GLSL
#define STROBE_GROUP_GLSL

const int kGroupSide = 8;

// The first of the texels of a tile that an invocation looks at: every eighth along both axes.
ivec2 ownFirst(ivec2 first) { return first + ivec2(gl_LocalInvocationID.xy); }

// Where a texel comes in a tile so wide, in raster order.
uint placeInTile(ivec2 texel, ivec2 first, int width) {
  ivec2 within = texel - first;
  return uint(within.y * width + within.x);
}

shared uint group_greatest, group_first;

// Has this invocation the greatest value of the group, each at least 0, and of those as great the first place? One has, where
// no two that are as great have one place. All invocations ask: it waits for them.
bool isGreatest(float value, uint place) {
  if (gl_LocalInvocationIndex == 0u) {
    group_greatest = 0u;
    group_first = ~0u;
  }
  barrier();
  uint bits = floatBitsToUint(value);  // in the order of the values
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
