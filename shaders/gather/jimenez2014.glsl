// SPDX-License-Identifier: MIT
// Blur by pairs of taps, with linear ramps at edges and a mirrored background (Jimenez 2014, "Next Generation Post Processing
// in Call of Duty: Advanced Warfare", SIGGRAPH course). Follows public code that is derived from the course.
// In:  `color`: linear radiance.
//      `depth`: view depth, metres; +inf for the sky.
//      `velocity`: displacement d(X) of the surface at each pixel X, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
//      `slowest`: length of the shortest displacement around each tile, px over the exposure (absent: 0).
//      `valid`: mask, above 1/2 where the layer has a surface (absent: everywhere).
//      `background_depth`, `background_valid`: depth and mask (above 1/2) of the surface that a ray revealed (absent: none).
// Out: `blurred`: rgb: linear radiance times alpha; a: alpha, below 1 only over a revealed surface.
// Method: d is the dominant displacement. Copy pixel X if the blur radius of d is at most `copy_below`.
//   1. Places: N = `samples` taps are s = 1/2 + jitter, 3/2 + jitter, ... steps of |d|/N from X; in a centred exposure,
//      as pairs at +s and -s, with N rounded up to an even number. `count` = adaptive then lowers N to the largest even
//      number up to |d| in px, but at least 2.
//   2. If `slowest` > `cheap_ratio` * |d|, and no surface is revealed at X, the result is the plain mean of the taps.
//   3. Weight of the tap at Y: b * clamp(rX - max(s - 1, 0), 0, 1) + f * clamp(rY - max(s - 1, 0), 0, 1). rX and rY are
//      the blur radii at X and Y in steps, so each clamp is the share of the step at s that the surface covers. f is 1
//      if Y is nearer than X (by the relative difference `depth_extent`), 0 if Y is farther, 1/2 at equal depths. b is
//      1 - f. The parameter `direction` adds a factor to the second term.
//   4. With `mirror`, if one tap of a pair is nearer and faster than the other, both get its weight.
//   5. Result: (sum of weight * colour)/N, plus the colour of X with the weight 1 - (sum of weights)/N; alpha is 1.
//      Over a revealed surface, the result is the foreground alone, and alpha its weight: each weight is multiplied by
//      inFrontOf (1 in front of the revealed surface, 0 at its depth), and for a tap also by the clamp of rY.
// Fails: inside a silhouette the background is copied from outside, so that edges appear twice there. Outside a silhouette, the
//   background under the blurred object comes from the opposite side. There is one direction per tile.
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "lib/times.glsl"

struct Tap {
  vec3 color;
  float depth;
  vec2 d;        // px over the exposure
  float radius;  // of the blur, px
};

// Inputs of the gather at one pixel. `here`: tap at the pixel itself.
struct Gather {
  Tap here;
  vec2 d;               // dominant displacement, px over the exposure
  float spread_factor;  // largest distance of a surface from its raster position, as a share of its displacement
  float step_length;    // distance between taps, px
  bool over;            // true if a surface was revealed behind the pixel
  float background;     // depth of the revealed surface, metres
};

// Sums over taps. `shown`: rgb: sum of weighted colours; alpha: sum of weights. Over a revealed surface, both sums are
// over the foreground alone. `all`: sum of the weights of all taps.
struct Sums {
  vec4 shown;
  float all;
};

Tap tapAt(ivec2 pixel, float spread_factor) {
  Texel texel = texelAt(pixel);
  return Tap(texel.color, texel.depth, texel.d, spread_factor * lengthOf(texel.d));
}

// Factor, 0 to 1, on the spread of a tap's surface along the dominant displacement, by the parameter `direction`. `offset`:
// position of the tap relative to the pixel, px.
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

// Share, 0 to 1, of a step that the motion of a surface covers. `radius`: blur radius of the surface, px. `steps`:
// distance of the step from the pixel, in steps. `after`: true if the step is on the side of the times after the raster
// time.
// With a shutter curve, steps have equal weights and unequal lengths. The radius in steps is then n * w. n is the
// number of steps on this side of the raster time. w is the share of this side's weight in the time that the dominant
// motion needs to cover the radius.
float stepCoverage(Gather gather, float radius, float steps, bool after) {
#if FACT_weighted
  if (isWeighted()) {
    float farthest = lengthOf(gather.d) * gather.spread_factor;
    float over = farthest / gather.step_length * shareWithin(after, radius / lengthOf(gather.d));
    return clamp(over - max(steps - 1.0, 0.0), 0.0, 1.0);
  }
#endif
  return clamp(radius / gather.step_length - max(steps - 1.0, 0.0), 0.0, 1.0);
}

// Weight of a tap that is `steps` steps, and `offset` px, from the pixel.
float tapWeight(Gather gather, Tap tap, float steps, ivec2 offset, bool after) {
  float back = 0.5 + 0.5 * depthOrder(gather.here.depth, tap.depth, params.depth_extent);
  float spread_here = stepCoverage(gather, gather.here.radius, steps, after);
  float spread_tap = stepCoverage(gather, tap.radius, steps, after) * alongDominant(gather, tap, offset);
  return back * spread_here + (1.0 - back) * spread_tap;
}

// Weights of a pair of taps: both equal to the weight of the nearer and faster tap, if one tap is both.
vec2 mirrored(Tap a, Tap b, vec2 weights) {
  if (a.depth > b.depth && b.radius > a.radius) return vec2(weights.y, weights.y);
  if (b.depth > a.depth && a.radius > b.radius) return vec2(weights.x, weights.x);
  return weights;
}

// Share of a tap's weight that belongs to the foreground, over a revealed background.
float frontShare(Gather gather, Tap tap, float steps, bool after) {
  return inFrontOf(tap.depth, gather.background, params.depth_extent) * stepCoverage(gather, tap.radius, steps, after);
}

// Offsets of the two taps of a pair from the pixel, px: one for a time before the raster time, one for a time after it.
struct Pair {
  ivec2 before, after;
};

// Offsets of a pair of taps. `steps`: distance of both taps from the pixel, in steps. `count` steps span the displacement d.
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

// Sums after one more pair of taps. `sides`: factors on the weights of the taps at times before (x) and after (y) the raster
// time.
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

// Sums after one more pair of taps. With a shutter curve, the weights of the taps are multiplied by the weights of both
// sides of the exposure. The two cases call withPairOf separately: compiling the code for shutter curves
// (FACT_weighted) then changes no bit of a picture with a box shutter.
Sums withPair(Sums sums, Gather gather, ivec2 pixel, Pair pair, float steps) {
#if FACT_weighted
  if (isWeighted()) {
    return withPairOf(sums, gather, pixel, pair, steps, vec2(sideFactor(false), sideFactor(true)));
  }
#endif
  return withPairOf(sums, gather, pixel, pair, steps, vec2(1));
}

// Sums after one more single tap, for an exposure on one side of the raster time.
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

// Number of taps at a pixel: an even number if taps come in pairs.
int sampleCount(vec2 d) {
  int most = isCentred(frame.shutter) ? (params.samples + 1) / 2 * 2 : params.samples;
#if PARAM_count == count_adaptive
  return min(max(int(lengthOf(d)) / 2 * 2, 2), most);
#else
  return most;
#endif
}

// True if the shortest displacement around the tile is nearly as long as the dominant one, so that taps need no weights.
bool movesAsOne(ivec2 pixel, vec2 d) {
  return slowest_at(pixel / params.tile).x > params.cheap_ratio * lengthOf(d);
}

// Offset of a single tap from the pixel, px, if the exposure lies on one side of the raster time. `steps`: distance of the tap
// from the pixel, in steps. `count` steps span the displacement d.
ivec2 singleAt(vec2 d, int count, float steps) {
  bool after = frame.shutter.y > 0.0;
  float end = after ? frame.shutter.y : frame.shutter.x, part = steps / float(count);
#if FACT_weighted
  if (isWeighted()) return roundSymmetric(tapOffset(d, timeOutwards(after, part)));
#endif
  return roundSymmetric(tapOffset(d, end) * part);
}

// Mean of the taps without weights, except the weights of the two sides under a shutter curve.
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

// Result with weighted taps: linear radiance times alpha, and alpha.
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
