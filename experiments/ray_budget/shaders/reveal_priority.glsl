// SPDX-License-Identifier: MIT
// Ray priority of the masked pixels: the expected gain of a ray that reveals the background, as a difference of colours.
// In:  mask: > 1/2 at pixels whose background is to be revealed.
//      color: colour of the raster layer, linear radiance.
//      depth: linear view depth, metres; sky +inf.
//      id: instance + 1; sky 0.
//      velocity: displacement over the exposure, px.
//      dominant: longest displacement that reaches each tile, px over the exposure.
// Out: priority: ray priority of each pixel (lib/priority.glsl); 0 outside the mask.
// Method: let d be the displacement of the foreground at pixel X over the exposure, and g the displacement of its background.
//   At time t (in exposures after the raster time), the background counts as visible if the raster image has another, farther
//   instance at X + t (g - d). The gain at time t is then the difference of the colours there and at X, otherwise 0. The gain
//   of the pixel is the mean over the sample times, for g = 0 or for g = dominant, whichever is larger.
// Fails: misestimates the gain if the background has another displacement, or if its colours vary behind the foreground.
#include "lib/blur.glsl"
#include "lib/priority.glsl"
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
  uint priority = 0u;
  if (texelFetch(mask_tex, pixel, 0).x > 0.5) {
    vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
    vec2 dominant = finiteDisplacement(texelFetch(dominant_tex, pixel / params.tile, 0));
    priority = rankOf(max(params.least, max(gainOf(pixel, -d), gainOf(pixel, dominant - d))));
  }
  imageStore(priority_img, pixel, uvec4(priority));
}
