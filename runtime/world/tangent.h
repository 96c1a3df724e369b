// SPDX-License-Identifier: MIT
// Vertex tangents in the packed format of shaders/shared/scene.h.
#pragma once

#include "shared/scene.h"

namespace strobe::world {

// Packs a unit direction and a handedness, 1 or -1; 0 if the handedness is 0. Axes are exact, other directions within
// 1/10000 of a radian.
inline uint32_t packedTangent(const vec4& tangent) {
  if (tangent.w == 0) return 0;
  const vec3 direction = vec3(tangent) / (std::abs(tangent.x) + std::abs(tangent.y) + std::abs(tangent.z));
  vec2 folded(direction);
  if (direction.z < 0)
    folded = {std::copysign(1 - std::abs(direction.y), direction.x),
              std::copysign(1 - std::abs(direction.x), direction.y)};
  const uvec2 steps((folded + 1.0f) * float(TANGENT_LARGEST) + 0.5f);
  return steps.x | steps.y << TANGENT_BITS | (tangent.w < 0 ? TANGENT_NEGATIVE : 0) | TANGENT_PRESENT;
}

}  // namespace strobe::world
