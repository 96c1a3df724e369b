// SPDX-License-Identifier: MIT
// Mean radiance of each pixel over the exposure, by rays at few times and adaptive subdivision between them (adaptive
// quadrature).
// In:  `color`, `depth`: at the raster time: linear radiance; view depth, metres, +inf for the sky
//      `id`: instance + 1, geometry + 1; 0 for the sky
//      `hit`: instance + 1 (0 = sky), geometry, primitive
//      `velocity`: displacement, px over the exposure
//      `certain`: per cell: 1 where a gather along the motion is reliable, 1/2 if the cell is static, 1/4 if a
//        validation ray refuted one of these two cases, otherwise 0
//      `longest`: per cell: longest displacement of the surfaces that reach the cell, px over the exposure
// Out: `picture`: linear radiance, alpha 1
//      `error`: estimated standard deviation of `picture`, linear radiance
// Method: cells with `certain` = 1 that are not beside a refuted cell take the mean of `samples` texels along the motion;
//   static cells, and pixels that no motion reaches, copy `color`. Other pixels trace rays at some of the n times of the loop:
//   1. Trace first rays at every k-th time. k is the largest power of two such that a surface that moves by `longest`
//      over the exposure moves at most `pace` image widths between two rays.
//   2. For two successive rays, at the times number a < b, estimate the colours at the times between, and their error.
//      A difference of two colours is the difference of the channel that differs most.
//      - If both rays hit one surface and the raster image shows both hit points, use the colours of the surface's
//        texels along its path. The error is the larger difference between a ray and its texel.
//      - Otherwise use the mean of both rays. The error is the difference of the two rays.
//   3. For each time between: if the raster image shows a surface that is at the pixel at that time, compare the colour
//      of its texel with both rays, and add the smaller difference, divided by b - a, to the error.
//   4. Trace a ray half-way between if error * (b - a)/n > `allowance`. Then repeat steps 2 to 4 for both halves.
// Fails: misses a surface that appears and disappears between two rays of equal colour, unless the raster image shows it.
#include "lib/blur.glsl"
#include "lib/moving_rect.glsl"
#include "lib/times.glsl"
#include "mixin/static_background.glsl"

const int kLevels = 12;  // largest depth of the subdivision; enough for 2^12 times (the pipeline `adaptive` has at most 256)

// Result of one ray. Colours are multiplied by kSumScale (toSum of lib/sanitise.glsl), so that their sums stay finite.
struct Sample {
  vec3 color;
  uvec2 id;     // instance + 1, geometry + 1; 0 for the sky
  vec3 place;   // position of the hit point at the raster time: texel (xy), view depth (z)
  float apart;  // largest difference over the channels from the raster texel at `place`; kFar if it does not show the point
};

// True if the raster texel `at` shows the surface `id` at the view depth `depth`. `color`: colour of the texel, multiplied by
// kSumScale.
bool isShownAt(ivec2 at, uvec2 id, float depth, out vec3 color) {
  color = vec3(0);
  if (!isInside(at, ivec2(frame.size)) || texelFetch(id_tex, at, 0).xy != id) return false;
  if (relativeGap(texelFetch(depth_tex, at, 0).x, depth) > params.same_depth) return false;
  color = toSum(finiteColor(texelFetch(color_tex, at, 0)));
  return true;
}

// Position in the raster image, texels, clamped to at most two texels outside of the image.
vec2 clamped(vec3 place) { return clamp(vec2(place), vec2(-2), vec2(frame.size) + 1.0); }

// True if the raster texel nearest to `place` (texel, view depth) shows the surface `id`. `color`: as for isShownAt.
bool isShown(vec3 place, uvec2 id, out vec3 color) { return isShownAt(ivec2(round(clamped(place))), id, place.z, color); }

// Largest difference of two colours over the channels.
float apart(vec3 a, vec3 b) {
  vec3 by = abs(a - b);
  return max(by.r, max(by.g, by.b));
}

uint traced_rays = 0u;
float variance = 0.0;  // estimated variance of the pixel's mean, in the scale of sums, squared

#if PARAM_hit_color == hit_color_blended
// Blends the raster texels around `place` that show the surface `id`, at most four. Returns false if no texel shows
// this surface, or if the expected error is above a quarter of `allowance`. The expected error is share * range /
// sqrt(12): `share` is the share of the exposure that the sample stands for, `range` is the range of the texels'
// colours, and range / sqrt(12) is the standard deviation of a uniform distribution over this range. With a quarter,
// blends add less to the error of the adaptive pipeline than its choice of time intervals does (tried: 1, 1/4, 1/16).
// Texels with weights below 1e-3 are ignored, so that the rounding of a place at a texel's centre does not change the
// result.
bool isBlended(vec3 place, uvec2 id, float share, out vec3 color) {
  vec2 low = floor(clamped(place)), part = clamped(place) - low;
  vec3 least = vec3(3e38), most = vec3(-3e38);
  float weights = 0.0;
  color = vec3(0);
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1);
    vec2 along = mix(1.0 - part, part, equal(corner, ivec2(1)));
    vec3 texel;
    if (along.x * along.y < 1e-3 || !isShownAt(ivec2(low) + corner, id, place.z, texel)) continue;
    least = min(least, texel);
    most = max(most, texel);
    color += along.x * along.y * texel;
    weights += along.x * along.y;
  }
  if (weights < 1e-3 || apart(least, most) * share > sqrt(12.0) * params.allowance * kSumScale / 4.0) return false;
  color = clamp(color / weights, least, most);  // rounding must not lead out of the texels' range
  return true;
}
#endif

// Traces a ray through the pixel at the loop's time `number`. The sample stands for the share `share` of the exposure. The ray
// updates `static_background`, which later rays of the pixel reuse.
Sample sampleAt(ivec2 pixel, int number, float share, inout StaticBackground static_background) {
  ++traced_rays;
  uint slice = SLICE_SAMPLE + uint(number);
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = nearestAt(slice, ray, static_background);
  bool is_static_background = isStaticBackground(hit);
  Sample result = Sample(vec3(0), isHit(hit) ? uvec2(hit.instance, hit.geometry) + 1u : uvec2(0u), vec3(0), kFar);
  if (is_static_background && static_background.is_known) {
    result.color = toSum(static_background.color);
    return result;
  }
  vec3 raster_color = vec3(0);
  bool is_placed = !is_static_background && isHit(hit) && placeInRaster(hit, result.place);
  bool is_shown = is_placed && isShown(result.place, result.id, raster_color);
  bool is_blended = false;
#if PARAM_hit_color == hit_color_blended
  is_blended = is_placed && isBlended(result.place, result.id, share, result.color);
#endif
  if (!is_blended) {
    vec3 color = isHit(hit) ? shade(SLICE_RASTER, hit) : environment(ray.direction);
    if (is_static_background) static_background = staticBackgroundOf(hit, color);
    result.color = toSum(color);
    if (isHit(hit)) count_shaded(1u);
  }
  if (is_shown) result.apart = apart(raster_color, result.color);
  return result;
}

// True if both samples hit one surface, and the raster image shows both hit points.
bool isOneShownSurface(Sample a, Sample b) { return a.id == b.id && max(a.apart, b.apart) < kFar; }

// Difference of the samples a and b from a surface that the raster image shows and that is at the pixel at the time
// `number` of `count`. For each sample, take the largest difference over the channels. The result is the smaller of
// these two numbers; 0 if the raster image shows no such surface. The displacement d leads to one texel of the raster
// image, and the displacement of that texel decides if its surface is at the pixel. The tolerance is 3/4 px, because
// rounding the position to a texel moves it by up to 1/2 px along each axis, and by 0.71 px diagonally.
float apartFromShown(ivec2 pixel, vec2 d, int number, int count, Sample a, Sample b) {
  float t = sampleTime(number, count, 0.0);
  ivec2 texel = pixel + roundSymmetric(tapOffset(d, t));
  if (d == vec2(0) || !isInside(texel, ivec2(frame.size))) return 0.0;
  if (!isAt(pixel, texel, finiteDisplacement(texelFetch(velocity_tex, texel, 0)), t, 0.75)) return 0.0;
  vec3 color = toSum(finiteColor(texelFetch(color_tex, texel, 0)));
  return min(apart(color, a.color), apart(color, b.color));
}

// True if the times between the samples a and b need no ray. `at` and `end` are the numbers of these samples among `count`
// times, d is the longest displacement in the cell. `sum` is then the sum of the colours at the times between. The colours are
// raster texels along the path if both samples hit one surface that the raster image shows, otherwise the mean of a and b.
// `change`: estimated difference of the colours from the truth, mean over the interval.
bool needsNoRay(ivec2 pixel, vec2 d, Sample a, Sample b, int at, int end, int count, out vec3 sum, out float change) {
  bool one_shown_surface = isOneShownSurface(a, b);
  float length = float(end - at);
  sum = one_shown_surface ? vec3(0) : 0.5 * (length - 1.0) * (a.color + b.color);
  change = one_shown_surface ? max(a.apart, b.apart) : apart(a.color, b.color);
  for (int number = at + 1; number < end; ++number) {
    if (change * length > params.allowance * kSumScale * float(count)) return false;
    change += apartFromShown(pixel, d, number, count, a, b) / length;
    if (!one_shown_surface) continue;
    vec3 color;
    if (!isShown(mix(a.place, b.place, float(number - at) / length), a.id, color)) return false;
    sum += color;
  }
  return change * length <= params.allowance * kSumScale * float(count);
}

// Adds the variance of an interval that lasts the share `share` of the exposure. If the colour changes by `change` at a
// uniformly distributed time in the interval, the pixel's mean has the variance (change * share)^2 / 12.
void addChange(float change, float share) { variance += change * change * share * share / 12.0; }

// Distance in time between two successive first rays of a pixel, in samples: the largest power of two such that a
// surface with the displacement d moves at most `pace` image widths between the rays.
int firstStep(vec2 d, int count) {
  float longest = lengthOf(d);
  int step = 1;
  while (2 * step < count && longest * float(2 * step) <= params.pace * float(int(frame.size.x) * (count - 1))) step *= 2;
  return step;
}

// Mean radiance of the pixel over the exposure, by rays. The loop goes through the times in order. `from`: last sample that the
// sum includes; `at`: number of its time. `waiting`: stack of later samples that are already traced, with the earliest on top;
// `ends`: numbers of their times.
vec3 meanOver(ivec2 pixel, vec2 d) {
  int count = int(frame.slice_count), step = firstStep(d, count);
  StaticBackground static_background = staticBackgroundAt(pixel);
  Sample from, waiting[kLevels];
  int ends[kLevels], at = -1, depth = 0;
  ends[0] = 0;
  vec3 sum = vec3(0);
  while (at < count - 1) {
    int share = at < 0 ? step : ends[depth] - at;  // the first ray gets the weight of a full step
    waiting[depth] = sampleAt(pixel, ends[depth], float(share) / float(count), static_background);
    while (depth >= 0) {
      Sample to = waiting[depth];
      int end = ends[depth];
      vec3 between = vec3(0);
      float change = at < 0 ? 0.0 : apart(from.color, to.color);
      if (end - at > 1 && !needsNoRay(pixel, d, from, to, at, end, count, between, change)) break;
      addChange(change, float(end - at) / float(count));
      sum += to.color + between;
      from = to;
      at = end;
      --depth;
    }
    int end = depth < 0 ? at + 2 * step : ends[depth];
    ++depth;
    ends[depth] = min((at + end) / 2, count - 1);
  }
  return fromSum(sum / float(count));
}

// Mean radiance of the texels that pass over the pixel, if the surroundings move uniformly by the displacement of the pixel.
vec3 gathered(ivec2 pixel) {
  vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  ivec2 size = ivec2(frame.size);
  vec3 sum = vec3(0), last = vec3(0);
  for (int i = 0; i < params.samples; ++i) {
    ivec2 at = pixel + roundSymmetric(tapOffset(d, sampleTime(i, params.samples, 0.0)));
    vec3 color = toSum(finiteColor(texelFetch(color_tex, clampToImage(at, size), 0)));
    if (i > 0) addChange(apart(last, color), 1.0 / float(params.samples));
    last = color;
    sum += color;
  }
  return fromSum(sum / float(params.samples));
}

// Entry of `certain` for the pixel's cell. It is 0 beside a refuted cell, because the surface that a ray found there may also
// reach the neighbouring cells. `longest`: displacement that decides the times of the first rays, px over the exposure.
float certainAt(ivec2 cell, out vec2 longest) {
  float certain = texelFetch(certain_tex, cell, 0).x;
  longest = vec2(texelFetch(longest_tex, cell, 0));
  for (int k = 0; k < 9 && certain > 0.4; ++k) {
    ivec2 at = clampToImage(cell + ivec2(k % 3, k / 3) - 1, textureSize(certain_tex, 0));
    float other = texelFetch(certain_tex, at, 0).x;
    if (other < 0.2 || other > 0.3) continue;
    certain = 0.0;
    longest = vec2(texelFetch(longest_tex, at, 0));
  }
  return certain;
}

void run(ivec2 pixel) {
  vec3 color = vec3(texelFetch(color_tex, pixel, 0));
  if (frame.exposure > 0.0 && isInMovingRect(pixel)) {
    vec2 longest;
    float certain = certainAt(pixel / params.cell_side, longest);
    if (certain < 0.4) {
      color = meanOver(pixel, longest);
      count_samples(traced_rays);
    } else {
      count_gathered(1u);
      if (certain > 0.75) color = gathered(pixel);
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(picture_img, pixel, vec4(color, 1));
  imageStore(error_img, pixel, vec4(sqrt(variance) / kSumScale));
}
