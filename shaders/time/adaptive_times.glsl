// SPDX-License-Identifier: MIT
// Mean radiance of each pixel over the exposure, by rays at few times and adaptive subdivision between them (adaptive
// quadrature).
// In:  `color`:    linear radiance at the raster time
//      `depth`:    view depth, m; +inf for the sky
//      `id`:       instance + 1, geometry + 1; 0 for the sky
//      `hit`:      instance + 1 (0 = sky), geometry, primitive
//      `velocity`: px over the exposure
//      `certain`:  per cell: 1 if a gather along the motion is right, 1/2 if the cell is static, otherwise 0
//      `longest`:  per cell: longest displacement that reaches it, px over the exposure
// Out: `picture`:  linear radiance, alpha 1
// Method: the first rays are a power of two of samples apart, so that `longest` moves by at most `pace` image widths between
//      them. Two rays at times a < b of n are accepted if error * (b - a) / n <= `allowance`, by the largest channel.
//      Otherwise, or if the raster image shows a third surface that arrives between them, a ray halfway is traced. If both rays
//      hit one surface that the raster image shows, the times between take its texels along the way, and the error is the
//      larger difference between ray and texel; otherwise they take the mean of both rays, and the error is the difference of
//      their colours. With `allowance` = 0 the result is the mean of all n times. A certain cell takes the mean of `samples`
//      texels along the motion, without a ray.
// Fails: a surface that appears and disappears between two rays of equal colour, unless the raster image shows it.
#include "lib/blur.glsl"
#include "lib/moving_rect.glsl"
#include "lib/times.glsl"
#include "mixin/static_background.glsl"

const int kLevels = 12;  // depth of the subdivision: enough for 2^12 times; `selective` has at most 256

// Result of one ray. Colours are scaled by kSumScale (toSum of lib/sanitise.glsl).
struct Sample {
  vec3 color;
  uvec2 id;     // instance + 1, geometry + 1; 0 for the sky
  vec3 place;   // of the point at the raster time: texel, view depth
  float apart;  // largest difference from the raster image's colour at `place`; kFar if that does not show the point
};

// True if the raster image shows the surface at `place`; `color` is its texel there.
bool isKept(vec3 place, uvec2 id, out vec3 color) {
  color = vec3(0);
  ivec2 at = ivec2(round(clamp(vec2(place), vec2(-2), vec2(frame.size) + 1.0)));
  if (!isInside(at, ivec2(frame.size)) || texelFetch(id_tex, at, 0).xy != id) return false;
  if (relativeGap(texelFetch(depth_tex, at, 0).x, place.z) > params.same_depth) return false;
  color = toSum(finiteColor(texelFetch(color_tex, at, 0)));
  return true;
}

float apart(vec3 a, vec3 b) {
  vec3 by = abs(a - b);
  return max(by.r, max(by.g, by.b));
}

uint traced = 0u;

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

// True if both samples hit one surface and the raster image shows both points.
bool isTold(Sample a, Sample b) { return a.id == b.id && max(a.apart, b.apart) < kFar; }

// True if the raster image shows a third surface, neither a nor b, that displacement d brings to the pixel in this part of the
// exposure. Tolerance 3/4 px: tap and path are each rounded by up to 1/2 px, and 0.71 px is the diagonal of both.
bool comesAnother(ivec2 pixel, vec2 d, int part, int count, uvec2 a, uvec2 b) {
  float t = sampleTime(part, count, 0.0);
  ivec2 now = pixel + roundSymmetric(tapOffset(d, t));
  if (!isInside(now, ivec2(frame.size))) return false;
  uvec2 id = texelFetch(id_tex, now, 0).xy;
  if (id == a || id == b) return false;
  return isAt(pixel, now, finiteDisplacement(texelFetch(velocity_tex, now, 0)), t, 0.75);
}

// True if the times between two samples need no ray. `sum` is then the sum over these times: of raster texels along the way if
// the raster image shows them, otherwise of the mean of both samples.
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

// Distance between the first rays, in samples: a power of two.
int firstStep(vec2 d, int count) {
  float longest = lengthOf(d);
  int step = 1;
  while (2 * step < count && longest * float(2 * step) <= params.pace * float(int(frame.size.x) * (count - 1))) step *= 2;
  return step;
}

// `from`, at time `at`: the last sample in the sum. `waiting`: stack of later samples, traced already; the earliest is on top.
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

// Mean of the texels that pass over the pixel, for uniform motion.
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
