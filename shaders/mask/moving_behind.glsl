// SPDX-License-Identifier: MIT
// In:  valid (> 1/2: something was revealed), id (instance + 1, 0 = sky), velocity (px over the exposure) of that.
// Out: mask (1 where it moves, and is no sky).
#include "lib/blur.glsl"

// What nothing is in front of was revealed behind itself, and moves as that does: nothing comes out behind it.
bool isCovered(uint id) { return id != 0u && (instanceAt(id - 1u).path & PATH_COVERED) != 0u; }

void run(ivec2 pixel) {
  bool revealed = texelFetch(valid_tex, pixel, 0).x > 0.5 && isCovered(texelFetch(id_tex, pixel, 0).x);
  bool moves = !(lengthOf(vec2(texelFetch(velocity_tex, pixel, 0))) * reachFactor(frame.shutter) <= kStillRadius);
  imageStore(mask_img, pixel, vec4(revealed && moves ? 1 : 0));
}
