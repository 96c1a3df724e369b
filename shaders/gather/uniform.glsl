// SPDX-License-Identifier: MIT
// Time-uniform gather: every tap along the dominant displacement stands for the same share of the exposure, and counts
// or does not. Straight ramps; coverage of a moving object over anything at rest is exact up to sampling.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure), dominant (the same, per tile);
//      valid (> 1/2: the layer has a texel there; absent: everywhere);
//      after_velocity, after_dominant: the same two for the times after the capture, where the exposure is split there
//      (absent: motion is linear throughout);
//      behind_depth, behind_valid: what lies behind each pixel, where something was revealed (absent: nowhere).
// Out: blurred, colour times alpha and alpha.
// Taps: N at the midpoints (i + 1/2 + jitter)/N of the exposure, Y = X - d*t.
// Foreground: a tap in front of what lies behind X (what was revealed there, else the surface X itself shows) whose own
//   motion passes over X within the exposure. Its weight is 1/N of the exposure, times |d|/|d(Y)|: a slower surface is met
//   by fewer of the taps but passes over X for the whole of the exposure.
//   alpha = sum of the weights, at most 1.
//   What rests at X in front of what was revealed takes what is left of the exposure.
// Split: taps before the capture follow the displacements before it, taps after it those after. A tap's surface counts
//   by its own path in the part that the tap is in. Where the dominant motion goes on in about the same direction it may
//   also pass in the other part, the wrong way round: the taps of that part lie to the other side and do not meet it.
//   Where the dominant motion turns back both parts have their taps on one side, and it is met in both: taps of opposing
//   direction need not be thrown away.
// Background: if something was revealed, none: the result is the foreground alone, to be laid over the blurred revealed
//   layer. Else alpha becomes 1 by adding (1 - alpha) times the mean of the other taps that X or they themselves
//   reach: the taps at X's own depth whose motion passes over X, and farther ones no farther away than X's own surface
//   moves, which stand in for what it uncovers. X itself makes up what their weights lack of one tap, so that a tap
//   which hardly counts does not become all there is.
// Fails: without revealed layer the background inside of a silhouette is that from outside of it; background that
//   moves is uncorrelated in time with what covers it (a product of two means); one direction per tile.
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/stored.glsl"
#include "lib/times.glsl"

struct Tap {
  vec3 color;
  float depth;
  vec2 d, d_after;  // px over the exposure, before and after the capture
};

Tap tapAt(ivec2 pixel) {
  Texel texel = texelAt(pixel);
  vec2 d_after = texel.d;
#if HAS_after_velocity
  d_after = limited(texelFetch(after_velocity_tex, pixel, 0));
#endif
  return Tap(texel.color, texel.depth, texel.d, d_after);
}

// By which displacement, in px over the exposure, a tap taken at `offset` for time t passes over the pixel.
struct Passing {
  bool passes;
  vec2 d;
};

Passing passingOf(Tap tap, ivec2 offset, float t, bool turns_back) {
  bool after = t > 0.0;
#if HAS_after_velocity
  vec2 own = after ? tap.d_after : tap.d, other = after ? tap.d : tap.d_after;
  vec2 before_part = partBefore(frame.shutter), after_part = partAfter(frame.shutter);
  if (motionReaches(vec2(offset), own, after ? after_part : before_part)) return Passing(true, own);
  if (turns_back) return Passing(false, own);
  return Passing(motionReaches(vec2(offset), other, after ? before_part : after_part), other);
#else
  return Passing(motionReaches(vec2(offset), tap.d, frame.shutter), tap.d);
#endif
}

#if FACT_weighted
// What counts of the times at which a surface that moves by `d` passes over the i-th part of the way along the dominant
// displacement.
float weightOfPart(int i, vec2 d, vec2 along) {
  float dominant_px = max(lengthOf(along), 0.5);
  float longer = dominant_px / clamp(lengthOf(d), 0.5, dominant_px) * (dot(d, along) < 0.0 ? -1.0 : 1.0);
  vec2 ends = vec2(timeAt(float(i), params.samples), timeAt(float(i + 1), params.samples)) * longer;
  return abs(shareFromEnd(false, ends.y) - shareFromEnd(false, ends.x));
}
#endif

// What a tap counts of the mean of several, as those do whose surface moves by `d`: with an even shutter all alike.
float shareOfMean(int i, vec2 d, vec2 along) {
#if FACT_weighted
  if (isWeighted()) {
    float slower = clamp(lengthOf(d) / max(lengthOf(along), 0.5), 0.5 / max(lengthOf(along), 0.5), 1.0);
    return float(params.samples) * slower * weightOfPart(i, d, along);
  }
#endif
  return 1.0;
}

// Share of the exposure for which the i-th tap's surface is at the pixel, which passes over it by `d`: the tap stands for
// the part of the way along the dominant displacement that this takes the i-th part of the exposure for, a slower surface
// longer. By a shutter curve, what counts of the times at which that surface passes over this part of the way.
float timeShare(int i, vec2 d, vec2 along) {
  float dominant_px = max(lengthOf(along), 0.5), speed = lengthOf(d);
#if FACT_weighted
  if (isWeighted()) return weightOfPart(i, d, along);
#endif
  return dominant_px / (float(params.samples) * clamp(speed, 0.5, dominant_px));
}

bool rests(vec2 d) { return lengthOf(d) < 0.5; }

// Is the i-th tap, as far as it is not foreground, a sample of the pixel's background? `here_d`: how the pixel's surface
// moves.
float backgroundWeight(Tap here, Tap tap, int i, ivec2 offset, vec2 here_d, Passing passing, vec2 along) {
  float same = softDepth(here.depth, tap.depth, params.depth_extent);  // a nearer tap counts by what is not foreground
  float moved_px = reachFactor(frame.shutter) * lengthOf(here_d);
  bool is_uncovered = rests(here_d) ? offset == ivec2(0) : length(vec2(offset)) <= max(moved_px, 0.5) + 0.5;
  float spread = is_uncovered ? shareOfMean(i, here_d, along) : 0.0;
  return mix(spread, passing.passes ? shareOfMean(i, passing.d, along) : 0.0, same);
}

// What rests is there for all of the exposure, but only a tap that falls on the pixel itself would meet it.
float restsInFront(Tap here, float behind) {
  if (!rests(here.d) || !rests(here.d_after)) return 0.0;
  return inFrontOf(here.depth, behind, params.depth_extent);
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0)), d_after = d;
#if HAS_after_dominant
  d_after = vec2(texelFetch(after_dominant_tex, pixel / params.tile, 0));
#endif
  float reach = reachFactor(frame.shutter);
  if (reach * max(lengthOf(d), lengthOf(d_after)) <= kStillRadius) {
    imageStore(blurred_img, pixel, storedColor(vec4(vec3(texelFetch(color_tex, pixel, 0)), 1)));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  Tap here = tapAt(pixel);
  float behind = behindDepth(pixel, here.depth);
  float jitter = jitterOf(pixel);
  bool turns_back = dot(d, d_after) <= 0.0;
  vec3 front_sum = vec3(0), back_sum = vec3(0);
  float front = 0.0, back = 0.0;

  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter);
    bool after = t > 0.0;
    vec2 along = after ? d_after : d;
    ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(along, t)), size);
    if (!isValid(at)) continue;

    Tap tap = tapAt(at);
    float in_front = inFrontOf(tap.depth, behind, params.depth_extent);
    Passing passing = passingOf(tap, at - pixel, t, turns_back);
    float hides = passing.passes ? in_front : 0.0;
    float weight = hides > 0.0 ? hides * timeShare(i, passing.d, along) : 0.0;
    front += weight;
    front_sum += weight * toSum(tap.color);

    vec2 here_d = after ? here.d_after : here.d;
    float back_weight = (1.0 - in_front) * backgroundWeight(here, tap, i, at - pixel, here_d, passing, along);
    back += back_weight;
    back_sum += back_weight * toSum(tap.color);
  }

  if (front > 1.0) {
    front_sum /= front;
    front = 1.0;
  }
  if (hasBehind(pixel)) {
    float own = restsInFront(here, behind) * (1.0 - front);
    front_sum += own * toSum(here.color);
    front += own;
    imageStore(blurred_img, pixel, storedColor(vec4(fromSum(front_sum), front)));
    return;
  }
  vec3 background = back > 0.0 ? fromSum(back_sum / back) : here.color;
  if (back < 1.0) background = mix(here.color, background, back);
  imageStore(blurred_img, pixel, storedColor(vec4(fromSum(front_sum) + (1.0 - front) * background, 1)));
}
