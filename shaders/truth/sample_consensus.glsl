// SPDX-License-Identifier: MIT
// Consensus of the first samples of a pixel and of the eight pixels around, so that the other samples need fewer rays.
// In:  `static_background`: common surface of the static hits, or of the moving hits if none is static: instance + 2, geometry,
//        triangle (lib/consensus.glsl)
//      `static_mean`: rgb: mean linear radiance of the static hits; alpha: number of static hits
//      `contrast`: largest difference of a static sample's radiance from the mean before the sample, as a share of that mean
//      `shadows`: visible and blocked lights on two instances (lib/consensus.glsl)
// Out: `known_hit`: surface that the samples of all nine pixels agree on, and its triangle if they agree on one; x = 0 without
//        a consensus
//      `known_shadows`: for each of the two instances recorded for the pixel, the lights that are visible, or blocked,
//        in all samples of all nine pixels (lib/consensus.glsl)
//      `even_color`: rgb: linear radiance; alpha: 1 if all samples hit one surface and their radiance differs by at most the
//        share `even_within`, otherwise 0
//      `more`: 0 if these samples are enough, otherwise 1
// Method: compare the pixel with the eight pixels around, because a silhouette may cut off such a small part of a pixel
//   that no sample of the pixel hits this part. The samples of a neighbour then find the silhouette. The samples are
//   enough if their radiance is uniform, the camera is static, shading is frozen, no moving surface can be visible at
//   the pixel, and the pixel is not validated.
// Fails: misses a surface that lies between all of these samples.
#include "lib/validation.glsl"
#include "lib/moving_rect.glsl"
#include "lib/consensus.glsl"

// Shadows on an instance according to the samples of another pixel, in the form of lib/consensus.glsl. `kept`: shadows of two
// instances that the other pixel has recorded. `id`: instance + 2. All bits are set (no contradiction) if the other pixel's
// samples never hit the instance. No bit is set (unknown) if they hit more instances than `kept` holds.
uint shadowsBeside(uvec4 kept, uint id) {
  if (kept.x == id) return kept.y;
  if (kept.z == id) return kept.w;
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
  bool is_static = PARAM_one_shading != 0 && frame.camera_rests != 0u && !isInMovingRect(pixel);
  bool is_enough = is_static && is_even && !isValidated(pixel / kValidationBlock, params.validation_share);
  imageStore(more_img, pixel, vec4(is_enough ? 0.0 : 1.0));
}
