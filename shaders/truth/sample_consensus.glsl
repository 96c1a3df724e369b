// SPDX-License-Identifier: MIT
// Consensus of the first samples of a pixel and of the eight around it, so that the other samples need fewer rays.
// In:  `static_background`:        surface that the static hits have in common, or the moving hits if none is static: instance
//                       + 2, geometry, triangle
//      `static_mean`:         rgb: mean linear radiance of the static hits; alpha: their number
//      `contrast`:        largest difference of a static sample's radiance from the mean before it, as a share of that mean
//      `shadows`:       visible and blocked lights of two instances (lib/consensus.glsl)
// Out: `known_hit`:     surface that all samples hit, and its triangle if they hit only one; x = 0 without a consensus
//      `known_shadows`: visible and blocked lights of the pixel's two instances that all samples confirm (lib/consensus.glsl)
//      `even_color`:    rgb: radiance, alpha 1 if all samples hit one surface and differ by at most `even_within`; otherwise 0
//      `more`:          0 if these samples are enough, otherwise 1
// Method: compare the pixel with the eight around it: a silhouette that cuts off less of a pixel than the distance of its
//      samples is hit by samples of a neighbour. The samples are enough if their radiance is uniform, the camera is static,
//      frozen shading is used, no moving surface can be visible at the pixel, and the pixel is not audited.
// Fails: a surface that lies between all of these samples is not found.
#include "lib/validation.glsl"
#include "lib/moving_rect.glsl"
#include "lib/consensus.glsl"

// Lights of an instance that the samples of another pixel confirm: all bits if they never hit it, none if it is unknown which
// instances they hit.
uint shadowsBeside(uvec4 kept, uint whose) {
  if (kept.x == whose) return kept.y;
  if (kept.z == whose) return kept.w;
  return kept.z == kSeveralSurfaces ? 0u : 0xffffffffu;
}

void run(ivec2 pixel) {
  uvec4 own = texelFetch(static_background_tex, pixel, 0), known_shadows = texelFetch(shadows_tex, pixel, 0);
  bool one_triangle = isOneTriangle(own), one_surface = isOneSurface(own);
  float contrast = 0.0;
  ivec2 last = textureSize(static_background_tex, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    uvec4 ids = texelFetch(static_background_tex, at, 0), shadows = texelFetch(shadows_tex, at, 0);
    one_triangle = one_triangle && ids.xyz == own.xyz;
    one_surface = one_surface && ids.xy == own.xy;
    known_shadows.y &= shadowsBeside(shadows, known_shadows.x);
    known_shadows.w &= shadowsBeside(shadows, known_shadows.z);
    contrast = max(contrast, texelFetch(contrast_tex, at, 0).x);
  }
  uvec4 known_hit = one_triangle ? own : uvec4(own.xy, kSeveralSurfaces, 0u);
  imageStore(known_hit_img, pixel, one_surface ? known_hit : uvec4(kNoSurface));
  imageStore(known_shadows_img, pixel, known_shadows);
  vec4 static_mean = texelFetch(static_mean_tex, pixel, 0);
  bool is_even = one_surface && contrast <= params.even_within && static_mean.a > 0.0;
  imageStore(even_color_img, pixel, is_even ? vec4(static_mean.rgb, 1) : vec4(0));
  bool stands = PARAM_one_shading != 0 && frame.camera_rests != 0u && !isInMovingRect(pixel);
  bool is_enough = stands && is_even && !isValidated(pixel / kValidationBlock, params.validation_share);
  imageStore(more_img, pixel, vec4(is_enough ? 0.0 : 1.0));
}
