// SPDX-License-Identifier: MIT
// What the first samples of a pixel and of the eight around it agree about. A silhouette that cuts off less of a pixel
// than samples lie apart is seen by its neighbours.
// In:  ground (what samples have seen at rest: whose, geometry, triangle), still (rgb: mean colour of that), unlike (how
//      far the colours are from it), shadows (lights by bits: free from there at all samples, blocked).
// Out: known_hit (the triangle at rest that all see, whose = 0 without any), known_shadows (of the lights, where all see
//      one surface: free at all of their samples, blocked), even_color (rgb: that colour, a = 1 where all see
//      one surface, in colours as good as equal).
#include "lib/seen.glsl"

void run(ivec2 pixel) {
  uvec4 own = texelFetch(ground_tex, pixel, 0);
  bool one_triangle = isOneTriangle(own), one_surface = isOneSurface(own);
  float unlike = 0.0;
  uvec2 shadows = texelFetch(shadows_tex, pixel, 0).xy;
  ivec2 last = textureSize(ground_tex, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    uvec4 seen = texelFetch(ground_tex, at, 0);
    one_triangle = one_triangle && seen.xyz == own.xyz;
    one_surface = one_surface && seen.xy == own.xy;
    shadows &= texelFetch(shadows_tex, at, 0).xy;
    unlike = max(unlike, texelFetch(unlike_tex, at, 0).x);
  }
  imageStore(known_hit_img, pixel, one_triangle ? own : uvec4(kSeenNothing));
  imageStore(known_shadows_img, pixel, uvec4(one_surface ? shadows : uvec2(0u), 0u, 0u));
  bool is_even = one_surface && unlike <= params.even_within;
  imageStore(even_color_img, pixel, is_even ? vec4(texelFetch(still_tex, pixel, 0).rgb, 1) : vec4(0));
}
