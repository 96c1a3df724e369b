// SPDX-License-Identifier: MIT
// Texels next to which something moves otherwise.
// In:  velocity, after_velocity (px over the exposure; absent: velocity).
// Out: near (1 where a texel of the eight around, within the picture, moves otherwise).
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

vec4 motionAt(ivec2 at) {
  vec2 d = finiteDisplacement(texelFetch(velocity_tex, at, 0)), after = d;
#if HAS_after_velocity
  after = finiteDisplacement(texelFetch(after_velocity_tex, at, 0));
#endif
  return vec4(d, after);
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(velocity_tex, 0);
  vec4 here = motionAt(pixel);
  bool otherwise = false;
  for (int k = 0; k < 9; ++k) {
    vec4 there = motionAt(clampToImage(pixel + ivec2(k % 3, k / 3) - 1, size));
    if (there == here) continue;
    otherwise = otherwise || movesOtherwise(there.xy, here.xy, params.slowest);
#if HAS_after_velocity
    otherwise = otherwise || movesOtherwise(there.zw, here.zw, params.slowest);
#endif
  }
  if (otherwise) imageStore(near_img, pixel, vec4(1));
}
