// SPDX-License-Identifier: MIT
// Summary of the surfaces that the time samples of a pixel hit, as (instance + 2, geometry, triangle, distance). Ground truth
// skips rays where the summaries of the first samples agree (docs/truth.md). A moving surface is in the summary only if the
// samples hit no static surface.
#ifndef STROBE_CONSENSUS_GLSL
#define STROBE_CONSENSUS_GLSL

// Special values of the first component of a summary, which otherwise is instance + 2: no surface yet, the sky, or several
// surfaces. The third component, the triangle, may be kSeveralSurfaces as well.
const uint kNoSurface = 0u, kSkySurface = 1u, kSeveralSurfaces = 0xffffffffu;

// True if all samples hit one geometry of one instance, or the sky.
bool isOneSurface(uvec4 ids) { return ids.x != kNoSurface && ids.x != kSeveralSurfaces; }
// True if all samples hit one triangle, or the sky.
bool isOneTriangle(uvec4 ids) { return isOneSurface(ids) && ids.z != kSeveralSurfaces; }

uint instanceOf(uvec4 ids) { return ids.x - 2u; }

// The *shadows* of an instance are one word: the results of the samples' shadow rays from this instance to the first 16 lights.
// Bit i is set if light i was visible in all samples that traced its shadow ray. Bit 16 + i is set if the light was blocked in
// all these samples. Both bits are set if no sample traced the ray, for example on a surface that faces away from the light.
// Neither is set if samples differ.
// A texel of the image of shadows holds two instances: (first instance + 2, its shadows, second instance + 2, its shadows). If
// samples hit a third instance, the third component becomes kSeveralSurfaces, and the second instance is lost.

// Shadows word of one sample. `visible_and_blocked`: bits of the lights found visible (x) and of the lights found blocked (y).
uint shadowsFrom(uvec2 visible_and_blocked) {
  uvec2 never = ~visible_and_blocked.yx;
  return (never.x & 0xffffu) | (never.y << 16u);
}
// Bits of the lights that are visible (x) or blocked (y) in all samples that traced their shadow rays. A light has neither bit
// if samples differ, or if no sample traced its ray.
uvec2 lightsOf(uint shadows) { return uvec2(shadows & ~(shadows >> 16u) & 0xffffu, (shadows & ~(shadows << 16u)) >> 16u); }
// Number of lights that have a bit in the result of `lightsOf`.
int countLights(uint shadows) { return bitCount((shadows ^ (shadows >> 16u)) & 0xffffu); }

// Shadows word of `instance` from the texel `kept`. If the texel does not hold this instance, the word is 0, so that no light
// counts as known.
uint shadowsOf(uvec4 kept, uint instance) {
  return kept.x == instance + 2u ? kept.y : kept.z == instance + 2u ? kept.w : 0u;
}

// Texel `kept` after one more sample, which hit `instance` and has the word `shadows` (`shadowsFrom`). The words of samples are
// combined by bitwise and.
uvec4 withShadows(uvec4 kept, uint instance, uint shadows) {
  uint id = instance + 2u;
  if (kept.x == kNoSurface) return uvec4(id, shadows, kNoSurface, 0u);
  if (kept.x == id) return uvec4(id, kept.y & shadows, kept.zw);
  if (kept.z == kNoSurface) return uvec4(kept.xy, id, shadows);
  if (kept.z == id) return uvec4(kept.xyz, kept.w & shadows);
  return uvec4(kept.xy, kSeveralSurfaces, 0u);
}

#endif
