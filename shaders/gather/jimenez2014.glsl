// SPDX-License-Identifier: MIT
// Gather of paired taps with linear ramps and mirrored background (Jimenez 2014, "Next Generation Post Processing in Call of
// Duty: Advanced Warfare", SIGGRAPH course), as its public descendants implement it.
// In:  color: linear radiance.
//      depth: view depth, metres; +inf for the sky.
//      velocity: displacement d, px over the exposure.
//      dominant: longest displacement that reaches each tile, px over the exposure.
//      slowest: length of the shortest displacement around each tile, px over the exposure (absent: no cheap path).
//      valid: > 1/2 where the layer has a surface (absent: everywhere).
//      background_depth, background_valid: view depth of the revealed surface, and > 1/2 where it exists (absent: nowhere).
// Out: blurred: rgb: linear radiance times alpha; a: alpha.
// Method: d = dominant. Copy pixel X if the blur radius of d is at most copy_below. Average the taps if slowest > cheap_ratio *
//   |d| and no surface was revealed behind X. Otherwise weight the taps ("full gather"). Counters count the three cases.
//   Taps are s = i + 1/2 + jitter steps of |d|/N from X: pairs at +-s if the exposure surrounds the raster time (N is even,
//   rounded up), otherwise single taps. With count = adaptive, N is an even number of at most |d| taps, at least 2.
//   A tap Y has the weight back * clamp(r(X) - max(s - 1, 0), 0, 1) + front * clamp(r(Y) - max(s - 1, 0), 0, 1), with r the
//   blur radius in steps. back + front = 1 by the order of the depths; both are 1/2 if the depths are equal. The parameter
//   `direction` scales the second term. With `mirror`, if one tap of a pair is nearer and faster, both taps have its weight. In
//   a tie both keep their own weights, so that mirrored images have mirrored results.
//   Result: sum of weight * colour over N; the rest of the exposure is the colour of X.
//   Alpha: 1. Over a revealed surface, the result is the foreground alone. A tap then counts to the degree that it is in front
//   of that surface and spreads over X. The rest of the exposure counts to the degree that X is in front.
// Fails: inside a silhouette the background is copied from outside, so its edges appear twice. Outside a silhouette, the
//   background under the object comes from the opposite side. There is one direction per tile.
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "lib/times.glsl"

struct Tap {
  vec3 color;
  float depth;
  vec2 d;        // px over the exposure
  float radius;  // px
};

// Inputs of the gather at one pixel.
struct Gather {
  Tap here;
  vec2 d;             // dominant displacement, px over the exposure
  float spread_factor;
  float step_length;  // px
  bool over;          // a surface was revealed behind the pixel
  float background;   // depth
};

// Sums over taps. `shown`: rgb: weighted colours of the visible part; alpha: weights of the visible part. `all`: weights of all
// taps.
struct Sums {
  vec4 shown;
  float all;
};

Tap tapAt(ivec2 pixel, float spread_factor) {
  Texel texel = texelAt(pixel);
  return Tap(texel.color, texel.depth, texel.d, spread_factor * lengthOf(texel.d));
}

// Share, 0 to 1, of a tap's blur that counts along the dominant displacement. The parameter `direction` chooses the rule.
float alongDominant(Gather gather, Tap tap, ivec2 offset) {
#if PARAM_direction == direction_projected
  float longest = lengthOf(gather.d);
  return min(abs(dot(tap.d / longest, gather.d / longest)), 1.0);
#elif PARAM_direction == direction_cosine
  return tap.radius > 0.0 ? min(abs(dot(tap.d / lengthOf(tap.d), gather.d / lengthOf(gather.d))), 1.0) : 1.0;
#elif PARAM_direction == direction_opposing
  return dot(tap.d, vec2(offset)) * (frame.shutter.x + frame.shutter.y) <= 0.0 ? 1.0 : 0.0;
#else
  return 1.0;
#endif
}

// Share of a step that a surface covers, 0 to 1. The step is `steps` away from the pixel; the surface has the blur radius
// `radius`, px. `after`: the step is on the side of the times after the raster time. With a shutter curve, all steps have the
// same weight: the radius in steps is the number of steps times the share of the weight until the dominant motion has covered
// the radius.
float colorRangeOver(Gather gather, float radius, float steps, bool after) {
#if FACT_weighted
  if (isWeighted()) {
    float farthest = lengthOf(gather.d) * gather.spread_factor;
    float over = farthest / gather.step_length * shareWithin(after, radius / lengthOf(gather.d));
    return clamp(over - max(steps - 1.0, 0.0), 0.0, 1.0);
  }
#endif
  return clamp(radius / gather.step_length - max(steps - 1.0, 0.0), 0.0, 1.0);
}

float tapWeight(Gather gather, Tap tap, float steps, ivec2 offset, bool after) {
  float back = 0.5 + 0.5 * depthOrder(gather.here.depth, tap.depth, params.depth_extent);
  float spread_here = colorRangeOver(gather, gather.here.radius, steps, after);
  float spread_tap = colorRangeOver(gather, tap.radius, steps, after) * alongDominant(gather, tap, offset);
  return back * spread_here + (1.0 - back) * spread_tap;
}

vec2 mirrored(Tap a, Tap b, vec2 weights) {
  if (a.depth > b.depth && b.radius > a.radius) return vec2(weights.y, weights.y);
  if (b.depth > a.depth && a.radius > b.radius) return vec2(weights.x, weights.x);
  return weights;
}

// Share of a tap's weight that belongs to the foreground, over a revealed background.
float frontShare(Gather gather, Tap tap, float steps, bool after) {
  return inFrontOf(tap.depth, gather.background, params.depth_extent) * colorRangeOver(gather, tap.radius, steps, after);
}

// Offsets of the two taps of a pair from the pixel, one for a time before the raster time and one for a time after it.
struct Pair {
  ivec2 before, after;
};

Pair pairAt(vec2 d, int count, float steps) {
#if FACT_weighted
  if (isWeighted()) {
    float share = 2.0 * steps / float(count);
    return Pair(roundSymmetric(tapOffset(d, timeOutwards(false, share))),
                roundSymmetric(tapOffset(d, timeOutwards(true, share))));
  }
#endif
  ivec2 offset = roundSymmetric(d * (steps / float(count)));
  return Pair(offset, -offset);
}

// Add a pair of taps. `sides`: weights of the times before (x) and after (y) the raster time.
Sums withPairOf(Sums sums, Gather gather, ivec2 pixel, Pair pair, float steps, vec2 sides) {
  ivec2 size = textureSize(color_tex, 0);
  ivec2 at_a = clampToImage(pixel + pair.before, size), at_b = clampToImage(pixel + pair.after, size);
  Tap a = tapAt(at_a, gather.spread_factor), b = tapAt(at_b, gather.spread_factor);
  vec2 weights = vec2(tapWeight(gather, a, steps, pair.before, false), tapWeight(gather, b, steps, pair.after, true));
#if PARAM_mirror
  if (isValid(at_a) && isValid(at_b)) weights = mirrored(a, b, weights);
#endif
  if (!isValid(at_a)) weights.x = 0.0;
  if (!isValid(at_b)) weights.y = 0.0;
  weights *= sides;
  sums.all += weights.x + weights.y;
  if (gather.over) weights *= vec2(frontShare(gather, a, steps, false), frontShare(gather, b, steps, true));
  sums.shown += vec4(weights.x * toSum(a.color) + weights.y * toSum(b.color), weights.x + weights.y);
  return sums;
}

// Add a pair of taps, with the weights of both sides if the shutter has a curve. Each branch adds its own sums, so that the
// result with a box shutter is the same, bit for bit, with and without FACT_weighted.
Sums withPair(Sums sums, Gather gather, ivec2 pixel, Pair pair, float steps) {
#if FACT_weighted
  if (isWeighted()) {
    return withPairOf(sums, gather, pixel, pair, steps, vec2(sideFactor(false), sideFactor(true)));
  }
#endif
  return withPairOf(sums, gather, pixel, pair, steps, vec2(1));
}

Sums withTap(Sums sums, Gather gather, ivec2 pixel, ivec2 offset, float steps) {
  ivec2 at = clampToImage(pixel + offset, textureSize(color_tex, 0));
  if (!isValid(at)) return sums;
  bool after = frame.shutter.y > 0.0;
  Tap tap = tapAt(at, gather.spread_factor);
  float weight = tapWeight(gather, tap, steps, offset, after);
  sums.all += weight;
  if (gather.over) weight *= frontShare(gather, tap, steps, after);
  sums.shown += vec4(weight * toSum(tap.color), weight);
  return sums;
}

// Number of taps at a pixel; even if taps come in pairs.
int sampleCount(vec2 d) {
  int most = isCentred(frame.shutter) ? (params.samples + 1) / 2 * 2 : params.samples;
#if PARAM_count == count_adaptive
  return min(max(int(lengthOf(d)) / 2 * 2, 2), most);
#else
  return most;
#endif
}

// True if all surfaces around the tile move nearly as fast as the dominant displacement.
bool movesAsOne(ivec2 pixel, vec2 d) {
  return slowest_at(pixel / params.tile).x > params.cheap_ratio * lengthOf(d);
}

// Offset of a single tap, if the exposure lies on one side of the raster time.
ivec2 singleAt(vec2 d, int count, float steps) {
  bool after = frame.shutter.y > 0.0;
  float end = after ? frame.shutter.y : frame.shutter.x, part = steps / float(count);
#if FACT_weighted
  if (isWeighted()) return roundSymmetric(tapOffset(d, timeOutwards(after, part)));
#endif
  return roundSymmetric(tapOffset(d, end) * part);
}

vec3 plainMean(ivec2 pixel, vec2 d, int count, float jitter) {
  ivec2 size = textureSize(color_tex, 0);
  vec3 sum = vec3(0);
  bool centred = isCentred(frame.shutter);
  int taken = centred ? count / 2 : count;
  for (int i = 0; i < taken; ++i) {
    float steps = float(i) + 0.5 + jitter;
    Pair pair = pairAt(d, count, steps);
    ivec2 offset = centred ? pair.before : singleAt(d, count, steps);
    sum += sideFactor(false) * toSum(texelAt(clampToImage(pixel + offset, size)).color);
    if (centred) sum += sideFactor(true) * toSum(texelAt(clampToImage(pixel + pair.after, size)).color);
  }
  return fromSum(sum / float(count));
}

vec4 fullGather(ivec2 pixel, Gather gather, int count, float jitter) {
  Sums sums = Sums(vec4(0), 0.0);
  bool centred = isCentred(frame.shutter);
  int taken = centred ? count / 2 : count;
  for (int i = 0; i < taken; ++i) {
    float steps = float(i) + 0.5 + jitter;
    if (centred) sums = withPair(sums, gather, pixel, pairAt(gather.d, count, steps), steps);
    else sums = withTap(sums, gather, pixel, singleAt(gather.d, count, steps), steps);
  }
  vec4 shown = sums.shown / float(count);
  float rest = 1.0 - sums.all / float(count);
  if (!gather.over) return vec4(fromSum(vec3(shown)) + rest * gather.here.color, 1);
  rest *= inFrontOf(gather.here.depth, gather.background, params.depth_extent);
  return vec4(fromSum(vec3(shown)) + rest * gather.here.color, shown.w + rest);
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  vec2 d = vec2(dominant_at(pixel / params.tile));
  float spread_factor = spreadFactor(frame.shutter);
  if (spread_factor * lengthOf(d) <= params.copy_below + (kStaticRadius - 0.5)) {
    count_copied(1u);
    imageStore(blurred_img, pixel, quantisedColor(vec4(vec3(color_at(pixel)), 1)));
    return;
  }

  int count = sampleCount(d);
  float jitter = jitterOf(pixel);
  bool over = hasBackground(pixel);
  if (!over && movesAsOne(pixel, d)) {
    count_cheap(1u);
    imageStore(blurred_img, pixel, quantisedColor(vec4(plainMean(pixel, d, count, jitter), 1)));
    return;
  }

  count_full(1u);
  Tap here = tapAt(pixel, spread_factor);
  Gather gather = Gather(here, d, spread_factor, lengthOf(d) / float(count), over, backgroundDepth(pixel, here.depth));
  imageStore(blurred_img, pixel, quantisedColor(fullGather(pixel, gather, count, jitter)));
}
