// SPDX-License-Identifier: MIT
// Motion blur of the Bevy engine (bevy_core_pipeline, motion_blur; since 0.14, 2024) for any anchor: each pixel gathers along
// its own displacement, without tiles. Written after the documentation and source of the engine.
// In:  color: linear.
//      depth: view depth, metres; +inf for the sky.
//      velocity: displacement d, px over the exposure.
// Out: blurred: linear, alpha 1.
// Method: N taps Y = X - d(X)*t at the midpoints (i + 1/2 + jitter)/N of the exposure; taps outside the image are left out. The
//   engine's exposure surrounds the raster time: anchor `centre`.
//   A tap counts if it is farther than X, or sky. Another tap counts if its displacement along d(X), in either sense, covers
//   the way to it: |d(Y) . d(X)|/|d(X)| * reach >= |Y - X|, with reach 1/2 for `centre` and 1 for the other anchors. The result
//   is the mean of the taps that count.
//   Copied: pixels that move by less than copy_below, and pixels without a tap that counts.
// Fails: surfaces do not blur beyond their silhouettes; inside, the background is the image from outside.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

float depthAt(ivec2 pixel) { return saneDepth(texelFetch(depth_tex, pixel, 0).x); }

// True if the displacement of a nearer tap covers the distance. The slack 1e-4 keeps the last tap of an equal displacement.
bool comesAsFar(vec2 d_tap, vec2 d, float distance_px, float spread_factor) {
  float d_length = lengthOf(d);
  return abs(dot(d_tap / d_length, d)) * spread_factor >= distance_px * (1.0 - 1e-4);
}

// True if a tap `offset` px from the pixel counts.
bool counts(ivec2 at, vec2 offset, float depth, vec2 d, float spread_factor) {
  float tap_depth = depthAt(at);
  if (tap_depth > depth || isinf(tap_depth)) return true;
  return d == vec2(0) || comesAsFar(displacementAt(at), d, lengthOf(offset), spread_factor);
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
