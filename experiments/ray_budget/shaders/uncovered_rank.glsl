// SPDX-License-Identifier: MIT
// The rank of masked pixels by what a ray behind them is expected to gain.
// In:  mask (> 1/2), color (linear), depth (view depth, sky +inf), id, velocity (px over the exposure), dominant (the
//      same, per tile).
// Out: rank (lib/rank.glsl; 0 outside of the mask).
// What is behind a pixel and goes g over the exposure, under a foreground that goes d, is seen at time t if another surface
// is at X + t (g - d) at the capture, farther away than the foreground. The gain is the mean over the times of the
// difference of the colours there, the larger one of g = 0 and g = dominant.
// Fails: backgrounds that move otherwise, or whose colours change.
#include "lib/blur.glsl"
#include "lib/rank.glsl"
#include "lib/sanitise.glsl"
#include "lib/times.glsl"

float gainOf(ivec2 pixel, vec2 relative) {
  ivec2 size = textureSize(depth_tex, 0);
  uint own = texelFetch(id_tex, pixel, 0).x;
  float depth = saneDepth(texelFetch(depth_tex, pixel, 0).x), sum = 0.0;
  vec3 color = finiteColor(texelFetch(color_tex, pixel, 0));
  for (int i = 0; i < params.samples; ++i) {
    ivec2 at = pixel + roundSymmetric(sampleTime(i, params.samples, 0.0) * relative);
    if (!isInside(at, size) || texelFetch(id_tex, at, 0).x == own) continue;
    if (!(saneDepth(texelFetch(depth_tex, at, 0).x) > depth)) continue;
    vec3 apart = abs(finiteColor(texelFetch(color_tex, at, 0)) - color);
    sum += max(apart.r, max(apart.g, apart.b));
  }
  return sum / float(params.samples);
}

void run(ivec2 pixel) {
  uint rank = 0u;
  if (texelFetch(mask_tex, pixel, 0).x > 0.5) {
    vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
    vec2 dominant = finiteDisplacement(texelFetch(dominant_tex, pixel / params.tile, 0));
    rank = rankOf(max(params.least, max(gainOf(pixel, -d), gainOf(pixel, dominant - d))));
  }
  imageStore(rank_img, pixel, uvec4(rank));
}
