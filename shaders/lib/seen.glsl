// SPDX-License-Identifier: MIT
// What time samples of a pixel have seen of what is at rest: (whose, geometry, triangle, a distance).
#ifndef STROBE_SEEN_GLSL
#define STROBE_SEEN_GLSL

// Whose surface: instance + 2, or one of these. A triangle may be kSeenSeveral too.
const uint kSeenNothing = 0u, kSeenSky = 1u, kSeenSeveral = 0xffffffffu;

// One geometry of one instance, or the sky; one triangle of it.
bool isOneSurface(uvec4 seen) { return seen.x != kSeenNothing && seen.x != kSeenSeveral; }
bool isOneTriangle(uvec4 seen) { return isOneSurface(seen) && seen.z != kSeenSeveral; }

uint instanceOf(uvec4 seen) { return seen.x - 2u; }

// Shadows of the first 16 lights by bits: free at all samples that asked, and from bit 16 on blocked at all of them; both where
// none asked, as where a surface turns away from the light. Of two instances: (the first + 2, its shadows, the second + 2, its
// shadows). With a third the second is kSeenSeveral.
uint shadowsFrom(uvec2 free_and_blocked) {
  uvec2 never = ~free_and_blocked.yx;
  return (never.x & 0xffffu) | (never.y << 16u);
}
// Lights that are known to be free, and to be blocked.
uvec2 lightsOf(uint shadows) { return uvec2(shadows & ~(shadows >> 16u) & 0xffffu, (shadows & ~(shadows << 16u)) >> 16u); }
int countLights(uint shadows) { return bitCount((shadows ^ (shadows >> 16u)) & 0xffffu); }

uint shadowsOf(uvec4 kept, uint instance) {
  return kept.x == instance + 2u ? kept.y : kept.z == instance + 2u ? kept.w : 0u;
}

uvec4 withShadows(uvec4 kept, uint instance, uint shadows) {
  uint whose = instance + 2u;
  if (kept.x == kSeenNothing) return uvec4(whose, shadows, kSeenNothing, 0u);
  if (kept.x == whose) return uvec4(whose, kept.y & shadows, kept.zw);
  if (kept.z == kSeenNothing) return uvec4(kept.xy, whose, shadows);
  if (kept.z == whose) return uvec4(kept.xyz, kept.w & shadows);
  return uvec4(kept.xy, kSeenSeveral, 0u);
}

#endif
