// SPDX-License-Identifier: MIT
// Feature-aware blur along two directions, for any anchor (Guertin, McGuire, Nowrouzezahrai 2014, "A Fast and Stable
// Feature-Aware Motion Blur Filter", HPG).
// In:  `color`, `depth`: linear radiance; view depth, metres, +inf for the sky.
//      `velocity`: displacement d(X) of the surface at each pixel X, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
//      `second`: displacement around each tile that differs most from `dominant`, px over the exposure (absent: `dominant`).
//      `variance`: variance of motion directions around each tile, 0 to 1 (absent: half of the taps take the second direction).
//      `slowest`: length of the shortest displacement around each tile, px over the exposure (absent: 0).
//      `valid`: mask, above 1/2 where the layer has a surface (absent: everywhere).
//      `background_depth`, `background_valid`: depth and mask (above 1/2) of the surface that a ray revealed (absent: none).
// Out: `blurred`: rgb: linear radiance times alpha; a: alpha, below 1 only over a revealed surface.
// Method: d is the dominant displacement at pixel X. X is copied if d is short (kCopiedRadius).
//   1. Places: tap i of N is at X - d * t_i. t_i is the time at the fraction 1 - (i + 1 + eta * jitter)/(N + 1) of the
//      exposure. In a centred exposure with odd N, the middle tap is skipped, because it is on X itself.
//   2. Second direction: for round(N/2 * smoothstep(0, 1/2, variance)) of the taps, |d| * v_c replaces d. v_c is a unit
//      vector (mixin/directions.glsl). These taps are skipped if v_c is 0.
//   3. Weight of the tap at Y, D px from X along the unit vector e: f * cone(D, rY) * wB + b * cone(D, rX) * wA +
//      2 * cylinder(D, min(rX, rY)) * max(wA, wB). wA = |v_c . e|, wB = |unit d(Y) . e|. rX, rY: blur radii, at least
//      1/2 px. f is 1 if Y is not farther than X, b is 1 if X is not farther than Y. X itself has the weight
//      N/(kappa * rX). If `slowest` is nearly |d| (kUniformShare), d replaces d(Y).
//   4. Result: weighted mean, alpha 1. Over a revealed surface, only the foreground's part of each weight counts in the
//      sum, and alpha is its share of all weights. The part is inFrontOf (1 in front of the revealed surface, 0 at its
//      depth) times the weight; for a tap, also times cylinder(D, rY) * wB.
// Fails: too opaque inside silhouettes, where the background is copied from outside. Surfaces that move along neither direction
//   stay sharp. Where many directions meet, there are noise and gaps.
#include "mixin/directions.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "mixin/tile_lookup.glsl"
#include "lib/times.glsl"

// A pixel is copied if the blur radius of the dominant displacement is at most this, px. This value and the next two are from
// the implementation by authors of the paper (G3D Innovation Engine, MotionBlur_gather.pix).
const float kCopiedRadius = 0.505;

// Motion around a tile is uniform if two conditions hold: the shortest displacement is at least kUniformShare times as
// long as the dominant displacement, and the blur radius of the shortest displacement is at least kUniformRadius px.
const float kUniformShare = 0.65;
const float kUniformRadius = 4.0;

struct Tap {
  vec3 color;
  float depth;
  float radius;    // blur radius, px
  vec2 direction;  // unit direction of the motion; 0 for a static surface
};

// Tap from a texel, with the displacement d in place of the texel's own. `spread_factor`: largest distance of a surface from
// its raster position, as a share of its displacement.
Tap tapFrom(Texel texel, vec2 d, float spread_factor) {
  return Tap(texel.color, texel.depth, max(spread_factor * lengthOf(d), 0.5), unitOf(d));
}

// Place of a tap: time in exposures, offset and distance from the pixel in px, and direction from the pixel (the sign does not
// matter).
struct Sample {
  float t;
  ivec2 offset;
  float distance_px;
  vec2 direction;  // unit
};

Sample sampleAt(int i, vec2 d, vec2 second, bool along_second, float jitter) {
  float t = timeAt(float(params.samples - i) - params.eta * jitter, params.samples + 1);
  float d_length = lengthOf(d);
  vec2 offset = tapOffset(along_second ? d_length * second : d, t);
  return Sample(t, roundSymmetric(offset), abs(t) * d_length, along_second ? second : unitOf(d));
}

// Number of the pixel's samples that are taken along the second direction.
int secondCount(ivec2 tile) {
#if HAS_variance
  float share = smoothstep(0.0, 0.5, variance_at(tile).x);
  return int(floor(0.5 * float(params.samples) * share + 0.5));
#else
  return params.samples / 2;
#endif
}

// True if the motion around the tile is uniform: the shortest displacement there is nearly as long as the dominant displacement
// d, and is not short itself (kUniformShare, kUniformRadius). All taps are then treated as moving by d.
bool movesAsOne(ivec2 tile, vec2 d, float spread_factor) {
  float slowest = slowest_at(tile).x;
  return slowest >= kUniformShare * lengthOf(d) && spread_factor * slowest >= kUniformRadius;
}

// Weight of a tap at the place `taken`. `here`: tap at the pixel itself. `second`: second direction of the pixel.
float tapWeight(Tap here, Tap tap, Sample taken, vec2 second) {
  float along_here = abs(dot(second, taken.direction));
  float along_tap = abs(dot(tap.direction, taken.direction));
  float in_front = softDepth(here.depth, tap.depth, params.depth_extent);
  float at_back = softDepth(tap.depth, here.depth, params.depth_extent);
  return in_front * cone(taken.distance_px, tap.radius) * along_tap +
         at_back * cone(taken.distance_px, here.radius) * along_here +
         2.0 * cylinder(taken.distance_px, min(here.radius, tap.radius)) * max(along_here, along_tap);
}

// Coverage of the pixel by the motion of a tap's surface, 0 to 1.
float covers(Tap tap, Sample taken) {
  float along_tap = tap.radius > 0.5 ? abs(dot(tap.direction, taken.direction)) : 1.0;
  return cylinder(taken.distance_px, tap.radius) * along_tap;
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  ivec2 tile = lookupTile(pixel, textureSize(dominant_tex, 0));
  vec2 d = vec2(dominant_at(tile));
  float spread_factor = spreadFactor(frame.shutter);
  if (spread_factor * lengthOf(d) <= kCopiedRadius) {
    count_copied(1u);
    imageStore(blurred_img, pixel, quantisedColor(vec4(vec3(color_at(pixel)), 1)));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  bool is_uniform = movesAsOne(tile, d, spread_factor);
  if (is_uniform) count_uniform(1u);
  Texel own = texelAt(pixel);
  Tap here = tapFrom(own, own.d, spread_factor);
  vec2 second = secondAt(pixel, tile, d, here.radius, params.gamma);
  int second_count = secondCount(tile);
  int skipped = sampleAtRasterTime(params.samples);
  bool over = hasBackground(pixel);
  float background = backgroundDepth(pixel, here.depth);
  float jitter = jitterOf(pixel);

  float all = float(params.samples) / (params.kappa * here.radius);
  float front = all * (over ? inFrontOf(here.depth, background, params.depth_extent) : 1.0);
  vec3 sum = toSum(here.color) * front;
  for (int i = 0; i < params.samples; ++i) {
    if (i == skipped) continue;
    bool along_second = isAlongSecond(i, second_count);
    if (along_second && second == vec2(0)) continue;
    Sample taken = sampleAt(i, d, second, along_second, jitter);
    ivec2 at = clampToImage(pixel + taken.offset, size);
    if (!isValid(at)) continue;

    Texel texel = texelAt(at);
    Tap tap = tapFrom(texel, is_uniform ? d : texel.d, spread_factor);
    float weight = tapWeight(here, tap, taken, second);
    all += weight;
    if (over) weight *= inFrontOf(tap.depth, background, params.depth_extent) * covers(tap, taken);
    front += weight;
    sum += weight * toSum(tap.color);
  }
  imageStore(blurred_img, pixel, quantisedColor(vec4(fromSum(sum / all), over ? front / all : 1.0)));
}
