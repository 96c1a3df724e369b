// SPDX-License-Identifier: MIT
// A stand-in for the post-process motion blur of game engines around 2020, built from what is public: the filter of
// Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", with its mirrored background.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure), dominant (the same, per tile).
// Out: blurred, linear, alpha 1.
// Taps: with the capture in the middle of the exposure, pairs at +-(i + 1/2 + jitter) steps of |d|/N (an odd N is
//   rounded up); with the capture at an end, N single taps at (i + 1/2 + jitter) steps of |d|/N.
// Weights, of a tap Y that is s = i + 1/2 + jitter steps away, u steps to a pixel, r the distance a pixel spreads:
//   w = back * clamp(u*r(X) - max(s - 1, 0), 0, 1) + front * clamp(u*r(Y) - max(s - 1, 0), 0, 1), where back + front =
//   1 by the order of the depths (1/2 each where equal). Of a pair the nearer and faster tap gives both their weight
//   (the mirror); both comparisons are strict, so that ties give a mirrored picture a mirrored result.
//   Result: sum of w*C / N, the rest of the exposure goes to the pixel itself.
// Fails: what it shows behind a moving object inside its silhouette is the picture from outside of it, so that edges
//   there appear a second time; outside, the background under the object comes from the opposite side.
#include "lib/blur.glsl"
#include "lib/jitter.glsl"
#include "lib/sanitise.glsl"

struct Tap {
  vec3 color;
  float depth;
  float radius;  // px
};

Tap tapAt(ivec2 pixel, float reach) {
  float limit_px = params.limit * float(frame.size.x);
  vec2 d = clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limit_px);
  vec3 color = finiteColor(texelFetch(color_tex, pixel, 0));
  return Tap(color, saneDepth(texelFetch(depth_tex, pixel, 0).x), reach * lengthOf(d));
}

// A tap and its weight. `step_length` px to a step, `steps` away.
float tapWeight(Tap here, Tap tap, float steps, float step_length) {
  float back = 0.5 + 0.5 * depthOrder(here.depth, tap.depth, params.depth_extent);
  float beyond = max(steps - 1.0, 0.0);
  float spread_here = clamp(here.radius / step_length - beyond, 0.0, 1.0);
  float spread_tap = clamp(tap.radius / step_length - beyond, 0.0, 1.0);
  return back * spread_here + (1.0 - back) * spread_tap;
}

vec2 mirrored(Tap a, Tap b, vec2 weights) {
  if (a.depth > b.depth && b.radius > a.radius) return vec2(weights.y, weights.y);
  if (b.depth > a.depth && a.radius > b.radius) return vec2(weights.x, weights.x);
  return weights;
}

void run(ivec2 pixel) {
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  float reach = reachFactor(frame.shutter);
  if (reach * lengthOf(d) <= kStillRadius) {
    imageStore(blurred_img, pixel, vec4(vec3(texelFetch(color_tex, pixel, 0)), 1));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  Tap here = tapAt(pixel, reach);
  float jitter = jitterOf(pixel);
  vec4 sum = vec4(0);  // weighted colours, weights

  if (isCentred(frame.shutter)) {
    int pairs = (params.samples + 1) / 2;
    float step_length = lengthOf(d) / float(2 * pairs);
    for (int i = 0; i < pairs; ++i) {
      float steps = float(i) + 0.5 + jitter;
      ivec2 offset = roundSymmetric(d * (steps / float(2 * pairs)));
      Tap a = tapAt(clampToImage(pixel + offset, size), reach);
      Tap b = tapAt(clampToImage(pixel - offset, size), reach);
      vec2 weights = vec2(tapWeight(here, a, steps, step_length), tapWeight(here, b, steps, step_length));
#if PARAM_mirror
      weights = mirrored(a, b, weights);
#endif
      sum += vec4(weights.x * a.color + weights.y * b.color, weights.x + weights.y);
    }
    sum /= float(2 * pairs);
  } else {
    vec2 far_end = tapOffset(d, frame.shutter.x < 0.0 ? frame.shutter.x : frame.shutter.y);
    float step_length = lengthOf(d) / float(params.samples);
    for (int i = 0; i < params.samples; ++i) {
      float steps = float(i) + 0.5 + jitter;
      ivec2 offset = roundSymmetric(far_end * (steps / float(params.samples)));
      Tap tap = tapAt(clampToImage(pixel + offset, size), reach);
      float weight = tapWeight(here, tap, steps, step_length);
      sum += vec4(weight * tap.color, weight);
    }
    sum /= float(params.samples);
  }
  imageStore(blurred_img, pixel, vec4(vec3(sum) + (1.0 - sum.w) * here.color, 1));
}
