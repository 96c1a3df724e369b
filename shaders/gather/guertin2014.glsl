// SPDX-License-Identifier: MIT
// Feature-aware gather along two directions, for any anchor (Guertin, McGuire, Nowrouzezahrai 2014, "A Fast and Stable
// Feature-Aware Motion Blur Filter", HPG).
// In:  color: linear radiance.
//      depth: view depth, metres; +inf for the sky.
//      velocity: displacement d, px over the exposure.
//      dominant: longest displacement that reaches each tile, px over the exposure.
//      second: displacement around each tile that differs most from dominant, px over the exposure (optional).
//      variance: variance of the directions around each tile, 0 to 1 (absent: half of the samples take the second direction).
//      slowest: length of the shortest displacement around each tile, px over the exposure (absent: no fast path).
//      valid: > 1/2 where the layer has a surface (absent: everywhere).
//      background_depth, background_valid: view depth of the revealed surface, and > 1/2 where it exists (absent: nowhere).
// Out: blurred: rgb: linear radiance times alpha; a: alpha.
// Method: the filter blurs pixel X along d = dominant, with t_i = lerp(-1, 1, (i + eta*jitter + 1)/(N + 1)). If the exposure
//   surrounds the raster time, taps lie at |d|/2 * t_i, without the tap on X itself (odd N). Otherwise they lie at |d| (t_i +
//   1)/2.
//   round(N/2 * smoothstep(0, 1/2, variance)) taps lie along the second direction v_c (mixin/directions.glsl) instead. They are
//   skipped if v_c is 0.
//   A tap Y at the distance D has the weight f*cone(D, rY)*wB + b*cone(D, rX)*wA + 2*cylinder(D, min(rX, rY))*max(wA, wB). Here
//   e is the sampled direction, wA = |v_c . e|, wB = |unit d(Y) . e|, r is the blur radius (at least 1/2 px), and f and b
//   compare the depths as shares of the depth. X itself has the weight N/(kappa*rX). The sum is normalised.
//   X is copied if the blur radius of d is at most 0.505 px. If the shortest displacement is at least 0.65 |d| and its radius
//   at least 4 px, d(Y) = d. Alpha: as in mcguire2012.glsl, with cylinder(D, rY) * wB for the taps.
// Fails: the blur inside silhouettes is too opaque, over background from outside. Surfaces that move along neither direction
//   stay sharp. Where many directions meet, there are noise and gaps.
#include "mixin/directions.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "mixin/tile_lookup.glsl"
#include "lib/times.glsl"

const float kCopiedRadius = 0.505;   // px
const float kUniformShare = 0.65;    // of the dominant displacement
const float kUniformRadius = 4.0;    // px

struct Tap {
  vec3 color;
  float depth;
  float radius;    // px
  vec2 direction;  // unit; 0 for a static surface
};

Tap tapFrom(Texel texel, vec2 d, float spread_factor) {
  return Tap(texel.color, texel.depth, max(spread_factor * lengthOf(d), 0.5), unitOf(d));
}

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

bool movesAsOne(ivec2 tile, vec2 d, float spread_factor) {
  float slowest = slowest_at(tile).x;
  return slowest >= kUniformShare * lengthOf(d) && spread_factor * slowest >= kUniformRadius;
}

float tapWeight(Tap here, Tap tap, Sample taken, vec2 second) {
  float along_here = abs(dot(second, taken.direction));
  float along_tap = abs(dot(tap.direction, taken.direction));
  float in_front = softDepth(here.depth, tap.depth, params.depth_extent);
  float at_back = softDepth(tap.depth, here.depth, params.depth_extent);
  return in_front * cone(taken.distance_px, tap.radius) * along_tap +
         at_back * cone(taken.distance_px, here.radius) * along_here +
         2.0 * cylinder(taken.distance_px, min(here.radius, tap.radius)) * max(along_here, along_tap);
}

// Share of the pixel that the motion of a tap covers, 0 to 1.
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
  bool coherent_cells = movesAsOne(tile, d, spread_factor);
  if (coherent_cells) count_uniform(1u);
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
    Tap tap = tapFrom(texel, coherent_cells ? d : texel.d, spread_factor);
    float weight = tapWeight(here, tap, taken, second);
    all += weight;
    if (over) weight *= inFrontOf(tap.depth, background, params.depth_extent) * covers(tap, taken);
    front += weight;
    sum += weight * toSum(tap.color);
  }
  imageStore(blurred_img, pixel, quantisedColor(vec4(fromSum(sum / all), over ? front / all : 1.0)));
}
