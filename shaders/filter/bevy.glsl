// SPDX-License-Identifier: MIT
// Motion blur of the Bevy engine, for any anchor (position of the exposure relative to the raster time: `end`, `centre`
// or `start`). Each pixel gathers along its own displacement, without tiles (bevy_core_pipeline, motion_blur; since
// 0.14, 2024). Written after the documentation and source of the engine.
// In:  `color`: linear radiance.
//      `depth`: view depth, metres; +inf for the sky.
//      `velocity`: displacement d(X) of the surface at each pixel X, px over the exposure.
// Out: `blurred`: linear radiance, alpha 1.
// Method: for pixel X and N taps, tap i is at Y = X - d(X) * t_i. t_i is the time at the share (i + 1/2 + jitter)/N of the
//   exposure. Taps outside the image are skipped. The engine itself has the anchor `centre`.
//   A tap counts if its surface is farther away than the surface at X, or is the sky. Any other tap counts only if its
//   own displacement is long enough to cover the distance to X along d(X), in either direction:
//   |d(Y) . d(X)| / |d(X)| * s >= |Y - X|. s is 1/2 for the anchor `centre` and 1 for the other anchors. The result is
//   the mean of the taps that count.
//   Pixels with a displacement below `copy_below` px, and pixels without a tap that counts, are copied.
// Fails: surfaces do not blur beyond their silhouettes. Inside a silhouette, the background is copied from outside.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

float depthAt(ivec2 pixel) { return saneDepth(texelFetch(depth_tex, pixel, 0).x); }

// True if the displacement `d_tap` of a nearer tap, projected on the pixel's displacement d, covers the distance from the tap
// to the pixel. `spread_factor`: 1/2 for the anchor `centre`, otherwise 1. The factor 1 - 1e-4 allows for rounding: without it,
// the last tap on a surface with the displacement d could be lost.
bool coversDistance(vec2 d_tap, vec2 d, float distance_px, float spread_factor) {
  float d_length = lengthOf(d);
  return abs(dot(d_tap / d_length, d)) * spread_factor >= distance_px * (1.0 - 1e-4);
}

// True if the tap at the texel `at` counts in the mean. A tap counts if its surface is farther away than the surface of
// the pixel, or is the sky. Any other tap counts only if its own motion covers the distance to the pixel. `offset`:
// position of the tap relative to the pixel, px. `depth`, d: view depth and displacement of the pixel. `spread_factor`:
// as in coversDistance.
bool counts(ivec2 at, vec2 offset, float depth, vec2 d, float spread_factor) {
  float tap_depth = depthAt(at);
  if (tap_depth > depth || isinf(tap_depth)) return true;
  return d == vec2(0) || coversDistance(displacementAt(at), d, lengthOf(offset), spread_factor);
}

void run(ivec2 pixel) {
  vec4 own = texelFetch(color_tex, pixel, 0);
  if (lengthOf(finiteDisplacement(texelFetch(velocity_tex, pixel, 0))) > limitPx()) count_clamped(1u);
  vec2 d = displacementAt(pixel);
  float spread_factor = spreadFactor(frame.shutter), longest = lengthOf(d);
  if (longest < params.copy_below || spread_factor * longest <= kStaticRadius) {
    count_copied(1u);
    imageStore(blurred_img, pixel, vec4(vec3(own), 1));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  float depth = depthAt(pixel), jitter = jitterOf(pixel);
  vec3 sum = vec3(0);
  float weights = 0.0;
  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter);
    vec2 offset = tapOffset(d, t);
    ivec2 at = pixel + roundSymmetric(offset);
    if (!isInside(at, size) || !counts(at, offset, depth, d, spread_factor)) continue;
    sum += toSum(finiteColor(texelFetch(color_tex, at, 0)));
    weights += 1.0;
  }
  vec3 color = weights > 0.0 ? fromSum(sum / weights) : vec3(own);
  imageStore(blurred_img, pixel, vec4(color, 1));
}
