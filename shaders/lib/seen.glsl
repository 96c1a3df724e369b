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

#endif
