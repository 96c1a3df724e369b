// SPDX-License-Identifier: MIT
// The motion blur of the Bevy engine (bevy_core_pipeline, motion_blur; since 0.14, 2024), for any anchor: no tiles, each
// pixel looks along its own displacement alone. Written from what the engine's documentation and source say it does.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure).
// Out: blurred (linear, alpha 1).
// Taps: N at the midpoints (i + 1/2 + jitter)/N of the exposure, Y = X - d(X)*t; those outside of the picture are left out.
//   The engine's window is that around the capture, which is `centre` here.
// Weights: a tap that is farther than X, or sky, counts. One that is nearer or as near counts if its own displacement's
//   share along that of X covers the way to it, whichever way it goes: |d(Y) . d(X)|/|d(X)| * reach >= |Y - X|; reach is
//   1 one-sided, 1/2 centred. The rest is not there: the result is the mean of the taps that count.
// Paths: what moves less than copy_below, and what has no tap that counts, is copied.
// Fails: nothing blurs beyond its silhouette; background inside of it is the picture from outside.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

float depthAt(ivec2 pixel) { return saneDepth(texelFetch(depth_tex, pixel, 0).x); }

// Can what is nearer have been where the pixel looks from? The slack keeps a tap at the very end of an equal path.
bool comesAsFar(vec2 d_tap, vec2 d, float distance_px, float reach) {
  float d_length = lengthOf(d);
  return abs(dot(d_tap / d_length, d)) * reach >= distance_px * (1.0 - 1e-4);
}

// True if a tap `offset` px from the pixel counts.
bool counts(ivec2 at, vec2 offset, float depth, vec2 d, float reach) {
  float tap_depth = depthAt(at);
  if (tap_depth > depth || isinf(tap_depth)) return true;
  return d == vec2(0) || comesAsFar(displacementAt(at), d, lengthOf(offset), reach);
}

void run(ivec2 pixel) {
  vec4 own = texelFetch(color_tex, pixel, 0);
  if (lengthOf(finiteDisplacement(texelFetch(velocity_tex, pixel, 0))) > limitPx()) count_clamped(1u);
  vec2 d = displacementAt(pixel);
  float reach = reachFactor(frame.shutter), longest = lengthOf(d);
  if (longest < params.copy_below || reach * longest <= kStillRadius) {
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
    if (!isInside(at, size) || !counts(at, offset, depth, d, reach)) continue;
    sum += toSum(finiteColor(texelFetch(color_tex, at, 0)));
    weights += 1.0;
  }
  vec3 color = weights > 0.0 ? fromSum(sum / weights) : vec3(own);
  imageStore(blurred_img, pixel, vec4(color, 1));
}
