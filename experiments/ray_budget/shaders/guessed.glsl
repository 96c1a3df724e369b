// SPDX-License-Identifier: MIT
// Where no rays will be, the guess of the samples that are left open.
// In:  seen (linear, sum of what is explained over the number of all samples; alpha: its share), open (bits), guess
//      (linear, of the others), mask (> 1/2 where these stay open).
// Out: seen_now, open_now: the same with that decided.
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec4 seen = texelFetch(seen_tex, pixel, 0);
  uvec2 open = texelFetch(open_tex, pixel, 0).xy;
  bool stays = texelFetch(mask_tex, pixel, 0).x > 0.5;
  if (!stays && (open.x | open.y) != 0u) {
    seen = vec4(finiteColor(seen + texelFetch(guess_tex, pixel, 0)), 1);
    open = uvec2(0u);
  }
  imageStore(seen_now_img, pixel, seen);
  imageStore(open_now_img, pixel, uvec4(open, 0u, 0u));
}
