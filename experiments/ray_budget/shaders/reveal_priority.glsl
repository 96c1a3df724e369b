// SPDX-License-Identifier: MIT
// Priority of masked pixels by the expected gain of a ray that reveals their background.
// In:  mask: > 1/2 at pixels whose background is to be revealed.
//      color: colour, linear.
//      depth: linear view depth, metres; sky +inf.
//      id: instance + 1; sky 0.
//      velocity: displacement over the exposure, px.
//      dominant: longest displacement that reaches each tile, px over the exposure.
// Out: priority: priority of each pixel (lib/priority.glsl); 0 outside the mask.
// Method: let the foreground at pixel X move by d over the exposure and its background by g. At time t the background is
//   visible if another, farther surface is at X + t (g - d) at the raster time. The gain is the mean over the sample times
//   of the difference between the colours there and at X, for g = 0 or g = dominant, whichever gives more.
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
