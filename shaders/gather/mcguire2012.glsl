// SPDX-License-Identifier: MIT
// Gather along the dominant displacement of the tile, for any anchor (McGuire, Hennessy, Bukowski, Osman 2012, "A
// Reconstruction Filter for Plausible Motion Blur", section 2.3).
// In:  color: linear radiance.
//      depth: view depth, metres; +inf for the sky.
//      velocity: displacement d, px over the exposure.
//      dominant: longest displacement that reaches each tile, px over the exposure.
//      second: displacement around each tile that differs most from dominant, px over the exposure (optional).
//      valid: > 1/2 where the layer has a surface (absent: everywhere).
//      background_depth, background_valid: view depth of the revealed surface, and > 1/2 where it exists (absent: nowhere).
// Out: blurred: rgb: linear radiance times alpha; a: alpha.
// Method: the filter blurs pixel X along d = dominant, with t_i = lerp(-1, 1, (i + jitter + 1)/(S + 1)). If the exposure
//   surrounds the raster time, as in the paper, taps lie at X + d/2 * t_i and the blur radius is |d|/2. The tap on X itself
//   (odd S) is left out, because the centre sample stands for it. If the exposure ends at the raster time, taps lie at X + d
//   (t_i + 1)/2, mirrored if it begins there, the radius is |d|, and all S taps count (Tan, Cui, Bhojan 2020). With two
//   directions, not in the paper but in later code, every odd tap lies along the second one (mixin/directions.glsl, gamma = 3/2
//   px).
//   A tap Y at the distance D has the weight f*cone(D, rY) + b*cone(D, rX) + 2*cylinder(D, rY)*cylinder(D, rX). The centre has
//   the weight 1/rX. The sum is normalised. f and b compare depths as shares of the depth and so have no scale.
//   Alpha: 1. Over a revealed surface the result is the foreground alone, and alpha the foreground's share of all weights. A
//   tap is foreground to the degree that it is in front of the revealed surface and that its own motion covers D (otherwise its
//   surface does not pass over X, for example a floor that slopes up to the viewer). The centre is foreground if it is in
//   front.
// Fails: the blur is too opaque inside silhouettes (6/7 in place of 1/2; docs/derivations.md) and has a step at silhouettes.
//   Ramps are not linear. Opacity depends on S. There is one direction per tile.
#include "mixin/directions.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "lib/times.glsl"

struct Tap {
  vec3 color;
  float depth;
  float radius;  // px
};

Tap tapAt(ivec2 pixel, float spread_factor) {
  Texel texel = texelAt(pixel);
  return Tap(texel.color, texel.depth, max(spread_factor * lengthOf(texel.d), 0.5));
}

float tapWeight(Tap here, Tap tap, float distance_px) {
  float in_front = softDepth(here.depth, tap.depth, params.depth_extent);
  float at_back = softDepth(tap.depth, here.depth, params.depth_extent);
  return in_front * cone(distance_px, tap.radius) + at_back * cone(distance_px, here.radius) +
         2.0 * cylinder(distance_px, tap.radius) * cylinder(distance_px, here.radius);
}

void run(ivec2 pixel) {
  if (!isValid(pixel)) {
    imageStore(blurred_img, pixel, vec4(0));
    return;
  }
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  float spread_factor = spreadFactor(frame.shutter);
  if (spread_factor * lengthOf(d) <= kStaticRadius) {
    imageStore(blurred_img, pixel, quantisedColor(vec4(vec3(texelFetch(color_tex, pixel, 0)), 1)));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  bool over = hasBackground(pixel);
  float jitter = jitterOf(pixel);
  int skipped = sampleAtRasterTime(params.samples);

  Tap here = tapAt(pixel, spread_factor);
  float background = backgroundDepth(pixel, here.depth);
  float all = 1.0 / here.radius;
  float front = all * (over ? inFrontOf(here.depth, background, params.depth_extent) : 1.0);
  vec3 sum = toSum(here.color) * front;

  vec2 second = secondAt(pixel, pixel / params.tile, d, here.radius, 1.5);
  vec2 second_d = second == vec2(0) ? d : lengthOf(d) * second;
  for (int i = 0; i < params.samples; ++i) {
    if (i == skipped) continue;
    float t = timeAt(float(params.samples - i) - jitter, params.samples + 1);
    vec2 offset = tapOffset(isAlongSecond(i, params.samples / 2) ? second_d : d, t);
    ivec2 at = clampToImage(pixel + roundSymmetric(offset), size);
    if (!isValid(at)) continue;

    Tap tap = tapAt(at, spread_factor);
    float distance_px = length(vec2(at - pixel));
    float weight = tapWeight(here, tap, distance_px);
    all += weight;
    if (over) weight *= inFrontOf(tap.depth, background, params.depth_extent) * cylinder(distance_px, tap.radius);
    front += weight;
    sum += weight * toSum(tap.color);
  }
  imageStore(blurred_img, pixel, quantisedColor(vec4(fromSum(sum / all), over ? front / all : 1.0)));
}
