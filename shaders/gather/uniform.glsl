// SPDX-License-Identifier: MIT
// Time-uniform gather: blurs along the dominant displacement with N taps. Each tap stands for an equal share of the exposure.
// Coverage by a moving surface over a static one changes linearly across edges and is exact up to sampling.
// In:  `color`: linear radiance.
//      `depth`: view depth, metres; +inf for the sky.
//      `velocity`: displacement d(X) of the surface at each pixel X, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
//      `velocity_post`, `dominant_post`: `velocity` and `dominant` after the raster time (absent: `velocity`, `dominant`).
//      `valid`: mask, above 1/2 where the layer has a surface (absent: everywhere).
//      `background_depth`, `background_valid`: depth and mask (above 1/2) of the surface that a ray revealed (absent: none).
// Out: `blurred`: rgb: linear radiance times alpha; a: alpha, below 1 only over a revealed surface.
// Method: tap i reads the texel Y = X - d * t_i around the pixel X. d is the dominant displacement, and t_i the time, in
//   exposures from the raster time, at the share (i + 1/2 + jitter)/N of the exposure.
//   Foreground: taps in front of the background of X, with a surface that passes over X within the exposure. The background is
//   the revealed surface or, without one, the surface at X. The weight of a tap is |d| / (N |d(Y)|): the slower its surface,
//   the longer it stays over X, and the fewer taps meet it. alpha is the sum of the weights, at most 1. A static surface at X
//   in front of a revealed one adds the rest, 1 - alpha.
//   Background: over a revealed surface, nothing is added. Otherwise the result gets (1 - alpha) times a mean of two
//   kinds of taps, and alpha becomes 1. The first kind are taps at the depth of X with a surface that passes over X.
//   The second kind are taps behind the surface at X, at most as far from X as this surface moves from its position at
//   the raster time. They stand in for the background that it disoccludes. If the weights of the mean add up to less
//   than one tap, the colour of X fills the rest, so that a tap of small weight cannot dominate.
//   If `velocity_post` is present, the two segments of the exposure are tested separately (`passingOf`).
// Fails: without a revealed layer, the background inside a silhouette is copied from outside. If the background moves, the
//   product of mean coverage and mean background differs from the mean of their product. There is one direction per tile.
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "lib/times.glsl"

struct Tap {
  vec3 color;
  float depth;
  vec2 d, d_after;  // displacement before (d) and after the raster time, each scaled to the whole exposure, px
};

Tap tapAt(ivec2 pixel) {
  Texel texel = texelAt(pixel);
  return Tap(texel.color, texel.depth, texel.d, limited(velocity_post_at(pixel)));
}

// Result of the test whether a tap's surface passes over the pixel. `d`: displacement of the surface, px over the exposure. If
// the motion has two segments, `d` belongs to the segment in which the surface passes.
struct Passing {
  bool passes;
  vec2 d;
};

// Tests if the surface of a tap passes over the pixel within the exposure. `offset`: position of the tap relative to the pixel,
// px. `t`: time of the tap. `turns_back`: true if the dominant motion turns back at the raster time.
// With two segments, before and after the raster time, the surface is tested in the segment that contains t. A surface
// that passes over the pixel only in the other segment counts too: the taps of that segment lie on the other side of
// the pixel and never meet the surface. If the dominant motion turns back, such a surface does not count, because the
// taps of both segments then lie on one side of the pixel, and the taps of the other segment meet the surface.
Passing passingOf(Tap tap, ivec2 offset, float t, bool turns_back) {
  bool after = t > 0.0;
#if HAS_velocity_post
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
// Weight, by the shutter curve, of the time that a surface with the displacement d needs to pass over distance i. The
// exposure is divided into parts of equal weight, one per sample. Distance i is the distance that the dominant motion
// (displacement `along`) covers in part i of the exposure.
float weightOfPart(int i, vec2 d, vec2 along) {
  float dominant_px = max(lengthOf(along), 0.5);
  float longer = dominant_px / clamp(lengthOf(d), 0.5, dominant_px) * (dot(d, along) < 0.0 ? -1.0 : 1.0);
  vec2 ends = vec2(timeAt(float(i), params.samples), timeAt(float(i + 1), params.samples)) * longer;
  return abs(shareFromEnd(false, ends.y) - shareFromEnd(false, ends.x));
}
#endif

// Weight of tap i in the mean of the background, for a surface with the displacement d; 1 with a box shutter. `along`: dominant
// displacement.
float shareOfMean(int i, vec2 d, vec2 along) {
#if FACT_weighted
  if (isWeighted()) {
    float slower = clamp(lengthOf(d) / max(lengthOf(along), 0.5), 0.5 / max(lengthOf(along), 0.5), 1.0);
    return float(params.samples) * slower * weightOfPart(i, d, along);
  }
#endif
  return 1.0;
}

// Share of the exposure during which the surface of tap i, with the displacement d, is at the pixel. The dominant displacement
// `along` is divided into as many parts as there are taps, and tap i stands for part i. The slower the surface, the longer it
// takes to pass over this part. With a shutter curve, the result is the weight of these times.
float timeShare(int i, vec2 d, vec2 along) {
  float dominant_px = max(lengthOf(along), 0.5), speed = lengthOf(d);
#if FACT_weighted
  if (isWeighted()) return weightOfPart(i, d, along);
#endif
  return dominant_px / (float(params.samples) * clamp(speed, 0.5, dominant_px));
}

// True if a surface with this displacement counts as static.
bool isStatic(vec2 d) { return lengthOf(d) < 0.5; }

// Weight of tap i as a sample of the pixel's background. The caller multiplies this weight by the share of the tap that is not
// foreground. `here`: tap at the pixel itself; `here_d`: displacement of its surface. `offset`: position of tap i relative to
// the pixel, px. `passing`: result of passingOf for tap i. `along`: dominant displacement.
float backgroundWeight(Tap here, Tap tap, int i, ivec2 offset, vec2 here_d, Passing passing, vec2 along) {
  // 1 if the tap has the depth of the pixel's surface or is nearer; falls to 0 with the distance of the tap behind the surface.
  float same = softDepth(here.depth, tap.depth, params.depth_extent);
  float moved_px = spreadFactor(frame.shutter) * lengthOf(here_d);
  bool is_disoccluded = isStatic(here_d) ? offset == ivec2(0) : length(vec2(offset)) <= max(moved_px, 0.5) + 0.5;
  float spread = is_disoccluded ? shareOfMean(i, here_d, along) : 0.0;
  return mix(spread, passing.passes ? shareOfMean(i, passing.d, along) : 0.0, same);
}

// Share, 0 to 1, of the pixel's own surface that counts as static foreground; 0 if the surface moves. The share of a
// static surface is 1 in front of the revealed surface, and falls to 0 as the two depths approach each other. A static
// surface covers the pixel for the whole exposure, but only a tap on the pixel itself meets it. So `run` adds the
// static surface separately.
float staticInFront(Tap here, float background) {
  if (!isStatic(here.d) || !isStatic(here.d_after)) return 0.0;
  return inFrontOf(here.depth, background, params.depth_extent);
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  ivec2 tile = pixel / params.tile;
  vec2 d = vec2(dominant_at(tile)), d_after = vec2(dominant_post_at(tile));
  float spread_factor = spreadFactor(frame.shutter);
  if (spread_factor * max(lengthOf(d), lengthOf(d_after)) <= kStaticRadius) {
    imageStore(blurred_img, pixel, quantisedColor(vec4(vec3(color_at(pixel)), 1)));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  Tap here = tapAt(pixel);
  float background = backgroundDepth(pixel, here.depth);
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
    float in_front = inFrontOf(tap.depth, background, params.depth_extent);
    Passing passing = passingOf(tap, at - pixel, t, turns_back);
    float coverage = passing.passes ? in_front : 0.0;
    float weight = coverage > 0.0 ? coverage * timeShare(i, passing.d, along) : 0.0;
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
  if (hasBackground(pixel)) {
    float own = staticInFront(here, background) * (1.0 - front);
    front_sum += own * toSum(here.color);
    front += own;
    imageStore(blurred_img, pixel, quantisedColor(vec4(fromSum(front_sum), front)));
    return;
  }
  vec3 back_color = back > 0.0 ? fromSum(back_sum / back) : here.color;
  if (back < 1.0) back_color = mix(here.color, back_color, back);
  imageStore(blurred_img, pixel, quantisedColor(vec4(fromSum(front_sum) + (1.0 - front) * back_color, 1)));
}
