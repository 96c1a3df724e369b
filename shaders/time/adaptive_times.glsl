// SPDX-License-Identifier: MIT
// Mean radiance of each pixel over the exposure, by rays at few times and adaptive subdivision between them (adaptive
// quadrature).
// In:  `color`: linear radiance at the raster time
//      `depth`: view depth, metres; +inf for the sky
//      `id`: instance + 1, geometry + 1; 0 for the sky
//      `hit`: instance + 1 (0 = sky), geometry, primitive
//      `velocity`: displacement, px over the exposure
//      `certain`: per cell: 1 where a gather along the motion is reliable, 1/2 if the cell is static, otherwise 0
//      `longest`: per cell: longest displacement of the surfaces that reach the cell, px over the exposure
// Out: `picture`: linear radiance, alpha 1
// Method: cells with `certain` = 1 take the mean of `samples` texels along the motion; static cells, and pixels that no motion
//   reaches, copy `color`. Other pixels trace rays at some of the n times of the loop:
//   1. Trace first rays at every k-th time. k is the largest power of two such that `longest` moves by at most `pace` image
//      widths between two rays.
//   2. Between two successive rays, at the times number a < b, estimate the colours and their error. If both rays hit one
//      surface and the raster image shows both points, the times between take that surface's texels along its path, and the
//      error is the larger difference between a ray and its texel. Otherwise the times between take the mean of both rays, and
//      the error is the difference of their colours. The channel with the largest error counts.
//   3. Trace a ray half-way between if error * (b - a)/n > `allowance`, or if the raster image shows a third surface that
//      arrives between the two times. Then repeat steps 2 and 3 for both halves.
// Fails: misses a surface that appears and disappears between two rays of equal colour, unless the raster image shows it.
#include "lib/blur.glsl"
#include "lib/moving_rect.glsl"
#include "lib/times.glsl"
#include "mixin/static_background.glsl"

const int kLevels = 12;  // largest depth of the subdivision; enough for 2^12 times (the pipeline `selective` has at most 256)

// Result of one ray. Colours are multiplied by kSumScale (toSum of lib/sanitise.glsl), so that their sums stay finite.
struct Sample {
  vec3 color;
  uvec2 id;     // instance + 1, geometry + 1; 0 for the sky
  vec3 place;   // position of the hit point at the raster time: texel (xy), view depth (z)
  float apart;  // largest difference of a channel from the raster texel at `place`; kFar if the texel does not show the point
};

// True if the raster image shows the surface `id` at `place` (texel, view depth). `color`: colour of the raster texel there,
// multiplied by kSumScale.
bool isKept(vec3 place, uvec2 id, out vec3 color) {
  color = vec3(0);
  ivec2 at = ivec2(round(clamp(vec2(place), vec2(-2), vec2(frame.size) + 1.0)));
  if (!isInside(at, ivec2(frame.size)) || texelFetch(id_tex, at, 0).xy != id) return false;
  if (relativeGap(texelFetch(depth_tex, at, 0).x, place.z) > params.same_depth) return false;
  color = toSum(finiteColor(texelFetch(color_tex, at, 0)));
  return true;
}

// Largest difference of two colours in a channel.
float apart(vec3 a, vec3 b) {
  vec3 by = abs(a - b);
  return max(by.r, max(by.g, by.b));
}

uint traced = 0u;

// Traces a ray through the pixel at time `part` of the loop. The ray updates `static_background`, which later rays of the pixel
// reuse.
Sample sampleAt(ivec2 pixel, int part, inout StaticBackground static_background) {
  ++traced;
  uint slice = SLICE_SAMPLE + uint(part);
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = nearestAt(slice, ray, static_background);
  bool is_static_background = isStaticBackground(hit);
  Sample result = Sample(vec3(0), isHit(hit) ? uvec2(hit.instance, hit.geometry) + 1u : uvec2(0u), vec3(0), kFar);
  if (is_static_background && static_background.is_known) {
    result.color = toSum(static_background.color);
    return result;
  }
  vec3 kept = vec3(0);
  bool is_kept =
      !is_static_background && isHit(hit) && placeInRaster(hit, result.place) && isKept(result.place, result.id, kept);
  result.color = kept;
#if PARAM_hit_color == hit_color_kept
  if (is_kept) result.apart = 0.0;
  if (is_kept) return result;
#endif
  vec3 color = isHit(hit) ? shade(SLICE_RASTER, hit) : environment(ray.direction);
  if (is_static_background) static_background = staticBackgroundOf(hit, color);
  result.color = toSum(color);
  if (is_kept) result.apart = apart(kept, result.color);
  return result;
}

// True if both samples hit one surface and the raster image shows both hit points.
bool isTold(Sample a, Sample b) { return a.id == b.id && max(a.apart, b.apart) < kFar; }

// True if the raster image shows a third surface that is at the pixel at time `part` of `count`. The displacement d leads to
// one texel of the raster image, and the displacement of that texel decides if its surface is at the pixel. a and b: ids of the
// surfaces that the rays before and after this time hit; a third surface has another id. The tolerance is 3/4 px, because
// rounding the position to a texel moves it by up to 1/2 px along each axis, and by 0.71 px diagonally.
bool comesAnother(ivec2 pixel, vec2 d, int part, int count, uvec2 a, uvec2 b) {
  float t = sampleTime(part, count, 0.0);
  ivec2 now = pixel + roundSymmetric(tapOffset(d, t));
  if (!isInside(now, ivec2(frame.size))) return false;
  uvec2 id = texelFetch(id_tex, now, 0).xy;
  if (id == a || id == b) return false;
  return isAt(pixel, now, finiteDisplacement(texelFetch(velocity_tex, now, 0)), t, 0.75);
}

// True if the times between the samples a and b need no ray. `at` and `end` are the numbers of these samples among `count`
// times, d is the longest displacement in the cell. `sum` is then the sum of the colours at the times between. The colours are
// raster texels along the path if both samples hit one surface that the raster image shows, otherwise the mean of a and b.
bool isKnown(ivec2 pixel, vec2 d, Sample a, Sample b, int at, int end, int count, out vec3 sum) {
  bool told = isTold(a, b);
  sum = 0.5 * float(end - at - 1) * (a.color + b.color);
  float unknown = told ? max(a.apart, b.apart) : apart(a.color, b.color);
  if (unknown * float(end - at) > params.allowance * kSumScale * float(count)) return false;
  if (told) sum = vec3(0);
  for (int part = at + 1; part < end; ++part) {
    if (d != vec2(0) && comesAnother(pixel, d, part, count, a.id, b.id)) return false;
    vec3 color;
    if (told && !isKept(mix(a.place, b.place, float(part - at) / float(end - at)), a.id, color)) return false;
    if (told) sum += color;
  }
  return true;
}

// Distance in time between two successive first rays of a pixel, in samples: the largest power of two such that the
// displacement d moves by at most `pace` image widths between the rays.
int firstStep(vec2 d, int count) {
  float longest = lengthOf(d);
  int step = 1;
  while (2 * step < count && longest * float(2 * step) <= params.pace * float(int(frame.size.x) * (count - 1))) step *= 2;
  return step;
}

// Mean radiance of the pixel over the exposure, by rays. The loop goes through the times in order. `from`: last sample that the
// sum includes; `at`: number of its time. `waiting`: stack of later samples that are already traced, with the earliest on top;
// `ends`: numbers of their times.
vec3 meanOver(ivec2 pixel) {
  vec2 d = vec2(texelFetch(longest_tex, pixel / params.cell_side, 0));
  int count = int(frame.slice_count), step = firstStep(d, count);
  StaticBackground static_background = staticBackgroundAt(pixel);
  Sample from, waiting[kLevels];
  int ends[kLevels], at = -1, depth = 0;
  ends[0] = 0;
  vec3 sum = vec3(0);
  while (at < count - 1) {
    waiting[depth] = sampleAt(pixel, ends[depth], static_background);
    while (depth >= 0) {
      Sample to = waiting[depth];
      int end = ends[depth];
      vec3 between = vec3(0);
      if (end - at > 1 && !isKnown(pixel, d, from, to, at, end, count, between)) break;
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
  vec3 sum = vec3(0);
  for (int i = 0; i < params.samples; ++i) {
    ivec2 at = pixel + roundSymmetric(tapOffset(d, sampleTime(i, params.samples, 0.0)));
    sum += toSum(finiteColor(texelFetch(color_tex, clampToImage(at, size), 0)));
  }
  return fromSum(sum / float(params.samples));
}

void run(ivec2 pixel) {
  vec3 color = vec3(texelFetch(color_tex, pixel, 0));
  float certain = texelFetch(certain_tex, pixel / params.cell_side, 0).x;
  bool is_reached = frame.exposure > 0.0 && isInMovingRect(pixel);
  if (is_reached && certain < 0.25) {
    color = meanOver(pixel);
    count_samples(traced);
  } else if (is_reached) {
    count_gathered(1u);
    if (certain > 0.75) color = gathered(pixel);
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(picture_img, pixel, vec4(color, 1));
}
