// SPDX-License-Identifier: MIT
// Summary of the surfaces that a pixel's time samples hit: (surface, geometry, triangle, distance). A moving surface is stored
// only if the samples hit no static one.
#ifndef STROBE_SEEN_GLSL
#define STROBE_SEEN_GLSL

// Values of the first component besides instance + 2. The triangle may be kSeveralSurfaces too.
const uint kNoSurface = 0u, kSkySurface = 1u, kSeveralSurfaces = 0xffffffffu;

// True if all samples hit one geometry of one instance, or the sky.
bool isOneSurface(uvec4 ids) { return ids.x != kNoSurface && ids.x != kSeveralSurfaces; }
// True if all samples hit one triangle, or the sky.
bool isOneTriangle(uvec4 ids) { return isOneSurface(ids) && ids.z != kSeveralSurfaces; }

uint instanceOf(uvec4 ids) { return ids.x - 2u; }

// Shadows of the first 16 lights on an instance, one word. Bit i is set if light i was visible from all samples that traced
// it, bit 16 + i if it was blocked from all these samples. Both are set if no sample traced it, for example on a surface
// that faces away from the light. A texel holds two instances: (first instance + 2, its shadows, second instance + 2, its
// shadows). If samples hit a third instance, the second becomes kSeveralSurfaces.
// `free_and_blocked`: bits of the lights found visible (x) and found blocked (y).
uint shadowsFrom(uvec2 free_and_blocked) {
  uvec2 never = ~free_and_blocked.yx;
  return (never.x & 0xffffu) | (never.y << 16u);
}
// Bits of the lights that are known to be visible, and of the lights that are known to be blocked.
uvec2 lightsOf(uint shadows) { return uvec2(shadows & ~(shadows >> 16u) & 0xffffu, (shadows & ~(shadows << 16u)) >> 16u); }
// Number of lights that are known to be visible or blocked.
int countLights(uint shadows) { return bitCount((shadows ^ (shadows >> 16u)) & 0xffffu); }

// Shadows of the instance in the texel; 0, which means unknown, if the texel does not hold it.
uint shadowsOf(uvec4 kept, uint instance) {
  return kept.x == instance + 2u ? kept.y : kept.z == instance + 2u ? kept.w : 0u;
}

// Texel with the shadows of one more sample on the instance.
uvec4 withShadows(uvec4 kept, uint instance, uint shadows) {
  uint whose = instance + 2u;
  if (kept.x == kNoSurface) return uvec4(whose, shadows, kNoSurface, 0u);
  if (kept.x == whose) return uvec4(whose, kept.y & shadows, kept.zw);
  if (kept.z == kNoSurface) return uvec4(kept.xy, whose, shadows);
  if (kept.z == whose) return uvec4(kept.xyz, kept.w & shadows);
  return uvec4(kept.xy, kSeveralSurfaces, 0u);
}

#endif
