// SPDX-License-Identifier: MIT
// What the first samples of a pixel and of the eight around it agree about. A silhouette that cuts off less of a pixel
// than samples lie apart is seen by its neighbours.
// In:  ground (what samples have seen at rest, or where that is nothing in motion: whose, geometry, triangle), still (rgb: mean
//      colour of that), unlike (how far the colours are from it), shadows (of two instances, as lib/seen.glsl has them).
// Out: known_hit (the surface that all see, and its triangle if that is one; whose = 0 without any),
//      known_shadows (of the pixel's instances, where all samples that see one agree), even_color (rgb: that colour,
//      a = 1 where all see one surface, in colours as good as equal), more (0 where these samples are enough: of one colour
//      before a camera at rest, where nothing in motion can be seen).
#include "lib/audit.glsl"
#include "lib/reached.glsl"
#include "lib/seen.glsl"

// Which of an instance's shadows samples of another pixel bear out.
uint shadowsBeside(uvec4 kept, uint whose) {
  if (kept.x == whose) return kept.y;
  if (kept.z == whose) return kept.w;
  return kept.z == kSeenSeveral ? 0u : 0xffffffffu;
}

void run(ivec2 pixel) {
  uvec4 own = texelFetch(ground_tex, pixel, 0), known_shadows = texelFetch(shadows_tex, pixel, 0);
  bool one_triangle = isOneTriangle(own), one_surface = isOneSurface(own);
  float unlike = 0.0;
  ivec2 last = textureSize(ground_tex, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    uvec4 seen = texelFetch(ground_tex, at, 0), shadows = texelFetch(shadows_tex, at, 0);
    one_triangle = one_triangle && seen.xyz == own.xyz;
    one_surface = one_surface && seen.xy == own.xy;
    known_shadows.y &= shadowsBeside(shadows, known_shadows.x);
    known_shadows.w &= shadowsBeside(shadows, known_shadows.z);
    unlike = max(unlike, texelFetch(unlike_tex, at, 0).x);
  }
  uvec4 known_hit = one_triangle ? own : uvec4(own.xy, kSeenSeveral, 0u);
  imageStore(known_hit_img, pixel, one_surface ? known_hit : uvec4(kSeenNothing));
  imageStore(known_shadows_img, pixel, known_shadows);
  vec4 still = texelFetch(still_tex, pixel, 0);
  bool is_even = one_surface && unlike <= params.even_within && still.a > 0.0;
  imageStore(even_color_img, pixel, is_even ? vec4(still.rgb, 1) : vec4(0));
  bool stands = PARAM_one_shading != 0 && frame.camera_rests != 0u && !isReached(pixel);
  bool is_enough = stands && is_even && !isAudited(pixel / kAuditBlock, params.audit);
  imageStore(more_img, pixel, vec4(is_enough ? 0.0 : 1.0));
}
