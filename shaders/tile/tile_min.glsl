// SPDX-License-Identifier: MIT
// Per tile, the length of the shortest displacement in it (Guertin et al. 2014; Jimenez 2014).
// In:  velocity (px over the exposure), valid (> 1/2: the texel counts; absent: all count).
// Out: shortest (px over the exposure, at most limit * image width; exactly that in a tile without texels that count).
//      The last tiles may be partial.
// Fails: lengths only; a tile that turns looks as uniform as one that slides.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

bool counts(ivec2 pixel) {
#if HAS_valid
  return texelFetch(valid_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(velocity_tex, 0);
  ivec2 first = pixel * params.tile;
  ivec2 end = min(first + params.tile, size);
  float shortest = limitPx();
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      if (!counts(ivec2(x, y))) continue;
      shortest = min(shortest, lengthOf(finiteDisplacement(texelFetch(velocity_tex, ivec2(x, y), 0))));
    }
  }
  imageStore(shortest_img, pixel, vec4(shortest, 0, 0, 0));
}
