// SPDX-License-Identifier: MIT
// Motion blur of the Bevy engine (bevy_core_pipeline, motion_blur; since 0.14, 2024) for any anchor: each pixel gathers along
// its own displacement, without tiles. Written after the documentation and source of the engine.
// In:  color: linear radiance.
//      depth: view depth, metres; +inf for the sky.
//      velocity: displacement d, px over the exposure.
// Out: blurred: linear radiance, alpha 1.
// Method: for pixel X, N taps Y = X - d(X)*t are at the midpoints (i + 1/2 + jitter)/N of the exposure. Taps outside the image
//   are left out. The engine's exposure surrounds the raster time: anchor `centre`.
//   A tap counts if it is farther than X, or sky. Any other tap counts if its displacement along d(X), in either sense, covers
//   the distance to X: |d(Y) . d(X)|/|d(X)| * reach >= |Y - X|, with reach 1/2 for `centre` and 1 for the other anchors. The
//   result is the mean of the taps that count.
//   Pixels that move by less than copy_below, and pixels without a tap that counts, are copied.
// Fails: surfaces do not blur beyond their silhouettes. Inside a silhouette, the background is copied from outside.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

float depthAt(ivec2 pixel) { return saneDepth(texelFetch(depth_tex, pixel, 0).x); }

// True if the displacement `d_tap` of a nearer tap, along the pixel's displacement d, covers the distance between tap and
// pixel. The factor 1 - 1e-4 keeps the last tap on a surface that moves by d too.
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
