// SPDX-License-Identifier: MIT
// Blur along the dominant displacement with taps weighted by depth and distance, for any anchor (McGuire, Hennessy, Bukowski,
// Osman 2012, "A Reconstruction Filter for Plausible Motion Blur", section 2.3).
// In:  `color`: linear radiance.
//      `depth`: view depth, metres; +inf for the sky.
//      `velocity`: displacement d(X) of the surface at each pixel X, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
//      `second`: displacement around each tile that differs most from `dominant`, px over the exposure (absent: `dominant`).
//      `valid`: mask, above 1/2 where the layer has a surface (absent: everywhere).
//      `background_depth`, `background_valid`: depth and mask (above 1/2) of the surface that a ray revealed (absent: none).
// Out: `blurred`: rgb: linear radiance times alpha; a: alpha, below 1 only over a revealed surface.
// Method: pixel X is blurred along d, the dominant displacement of its tile, with S taps, at t_i = lerp(-1, 1,
//   (i + jitter + 1)/(S + 1)). If the exposure surrounds the raster time, as in the paper, tap i is at X + t_i * d/2. The tap
//   on X itself (odd S) is left out, because the centre sample stands for it. If the exposure ends at the raster time,
//   tap i is at X + d (1 + t_i)/2; if it starts at the raster time, tap i is at X - d (1 - t_i)/2. In both of these
//   cases all S taps count (Tan, Cui, Bhojan 2020). With `directions` = two, as in later code of the filter, every odd
//   tap lies along a second direction (mixin/directions.glsl).
//   A tap at Y, D px from X, has the weight f * cone(D, rY) + b * cone(D, rX) + 2 * cylinder(D, rX) * cylinder(D, rY)
//   (lib/blur.glsl). The blur radius r of a surface is its largest distance from its raster position within the exposure, at
//   least 1/2 px. f is 1 if Y is not farther than X, b is 1 if X is not farther than Y; both fall to 0 over the relative depth
//   difference `depth_extent`. The centre sample has the weight 1/rX. The result is the weighted mean.
//   Alpha is 1. Over a revealed surface, the result is the foreground alone, and alpha its share of all weights. A tap is
//   foreground to the degree that it is in front of the revealed surface and its own motion covers the distance D. The centre
//   sample is foreground if it is in front of the revealed surface.
// Fails: too opaque inside silhouettes (6/7 instead of 1/2; docs/derivations.md), with a step at the silhouette. Coverage is
//   not linear across edges, and opacity depends on S. There is one direction per tile.
#include "mixin/directions.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layer.glsl"
#include "mixin/quantised.glsl"
#include "lib/times.glsl"

// Width, px, of the range of blur radii where the second direction changes from the perpendicular of the dominant
// displacement to the pixel's own displacement. The parameter `gamma` of the pass guertin2014 has the same value by
// default.
const float kGamma = 1.5;

struct Tap {
  vec3 color;
  float depth;
  float radius;  // of the blur, px
};

// Tap at a pixel. `spread_factor`: largest distance of a surface from its raster position, as a share of its displacement.
Tap tapAt(ivec2 pixel, float spread_factor) {
  Texel texel = texelAt(pixel);
  return Tap(texel.color, texel.depth, max(spread_factor * lengthOf(texel.d), 0.5));
}

// Weight of a tap at `distance_px` from the pixel. `here`: tap at the pixel itself.
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

  vec2 second = secondAt(pixel, pixel / params.tile, d, here.radius, kGamma);
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
