// SPDX-License-Identifier: MIT
// Time-uniform gather: every tap along the dominant displacement stands for the same share of the exposure, and counts
// or does not. Straight ramps; coverage of a moving object over anything at rest is exact up to sampling.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure), dominant (the same, per tile);
//      valid (> 1/2: the layer has a texel there; absent: everywhere);
//      behind_depth, behind_valid: what lies behind each pixel, where something was revealed (absent: nowhere).
// Out: blurred, colour times alpha and alpha.
// Taps: N at the midpoints (i + 1/2 + jitter)/N of the exposure, Y = X - d*t.
// Foreground: a tap in front of what lies behind X (what was revealed there, else the surface X itself shows) whose own
//   motion passes over X within the exposure. Its weight is 1/N of the exposure, times |d|/|d(Y)|: a slower surface is
//   met by fewer of the taps but passes over X for the whole of the exposure. alpha = sum of the weights, at most 1.
// Background: if something was revealed, none: the result is the foreground alone, to be laid over the blurred revealed
//   layer. Else alpha becomes 1 by adding (1 - alpha) times the mean of the other taps that X or they themselves
//   reach: the taps at X's own depth whose motion passes over X, and farther ones no farther away than X's own surface
//   moves, which stand in for what it uncovers. If there are none, of X itself.
// Fails: without revealed layer the background inside of a silhouette is that from outside of it; background that
//   moves is uncorrelated in time with what covers it (a product of two means); one direction per tile.
#include "lib/blur.glsl"
#include "lib/jitter.glsl"
#include "lib/sanitise.glsl"

struct Tap {
  vec3 color;
  float depth;
  vec2 d;  // px over the exposure
};

Tap tapAt(ivec2 pixel) {
  float limit_px = params.limit * float(frame.size.x);
  vec2 d = clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limit_px);
  return Tap(finiteColor(texelFetch(color_tex, pixel, 0)), saneDepth(texelFetch(depth_tex, pixel, 0).x), d);
}

bool isValid(ivec2 pixel) {
#if HAS_valid
  return texelFetch(valid_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

bool hasBehind(ivec2 pixel) {
#if HAS_behind_valid
  return texelFetch(behind_valid_tex, pixel, 0).x > 0.5;
#else
  return false;
#endif
}

float behindDepth(ivec2 pixel, float otherwise) {
#if HAS_behind_depth
  if (hasBehind(pixel)) return saneDepth(texelFetch(behind_depth_tex, pixel, 0).x);
#endif
  return otherwise;
}

// Share of the exposure that a tap stands for which passes over the pixel.
float timeShare(Tap tap, float dominant_px) {
  return dominant_px / (float(params.samples) * clamp(lengthOf(tap.d), 0.5, dominant_px));
}

// Is a tap that is not foreground a sample of the pixel's background?
float backgroundWeight(Tap here, Tap tap, ivec2 offset, float reach) {
  float same = softDepth(tap.depth, here.depth, params.depth_extent) *
               softDepth(here.depth, tap.depth, params.depth_extent);
  float spread = length(vec2(offset)) <= max(reach * lengthOf(here.d), 0.5) + 0.5 ? 1.0 : 0.0;
  float passes = motionReaches(vec2(offset), tap.d, frame.shutter) ? 1.0 : 0.0;
  return mix(tap.depth > here.depth ? spread : 0.0, passes, same);
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  float reach = reachFactor(frame.shutter);
  float dominant_px = lengthOf(d);
  if (reach * dominant_px <= kStillRadius) {
    imageStore(blurred_img, pixel, vec4(vec3(texelFetch(color_tex, pixel, 0)), 1));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  Tap here = tapAt(pixel);
  float behind = behindDepth(pixel, here.depth);
  float jitter = jitterOf(pixel);
  vec3 front_sum = vec3(0), back_sum = vec3(0);
  float front = 0.0, back = 0.0;

  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter, frame.shutter);
    ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(d, t)), size);
    if (!isValid(at)) continue;

    Tap tap = tapAt(at);
    float in_front = inFrontOf(tap.depth, behind, params.depth_extent);
    float passes = motionReaches(vec2(at - pixel), tap.d, frame.shutter) ? 1.0 : 0.0;
    float weight = in_front * passes * timeShare(tap, dominant_px);
    front += weight;
    front_sum += weight * tap.color;

    float back_weight = (1.0 - in_front) * backgroundWeight(here, tap, at - pixel, reach);
    back += back_weight;
    back_sum += back_weight * tap.color;
  }

  if (front > 1.0) {
    front_sum /= front;
    front = 1.0;
  }
  if (hasBehind(pixel)) {
    imageStore(blurred_img, pixel, vec4(front_sum, front));
    return;
  }
  vec3 background = back > 0.0 ? back_sum / back : here.color;
  imageStore(blurred_img, pixel, vec4(front_sum + (1.0 - front) * background, 1));
}
