// SPDX-License-Identifier: MIT
// Finds cells where a gather along the motion is reliable, because all surfaces that reach the cell move alike.
// In:  `bounds`: bounds of the displacements in each cell, px over the exposure
//      `velocity`: displacement, px over the exposure
//      `id`: instance + 1 at the raster time; 0 for the sky
//      `max_displacement`: longest displacement in the image, px over the exposure; absent: twice the image's diagonal
// Out: `certain`: 1 if the gather is reliable, 1/2 if the cell is static, 1/4 if a ray refuted one of these two cases,
//        otherwise 0
//      `longest`: longest displacement of the surfaces that reach the cell, px over the exposure
// Method: join the bounds of all cells that contain surfaces which reach this cell, or texels that a gather in this
//   cell reads. If the diagonal of the joined box is at most `apart_px`, validate the cell with `validation_rays` rays.
//   Each ray has its own pixel of the cell and its own part of the exposure, the same in every cell. The ray must hit
//   the point that the pixel's displacement brings to the pixel at the ray's time. Otherwise the cell has a surface
//   that the displacements of the raster time do not describe: it has a curved path, is disoccluded, or comes from
//   outside the image. `certain` is then 1/4, and `longest` is one of these:
//   - if the ray hits a point that moves farther than all displacements of the cell: the displacement of this point, at
//     most kAssumedDisplacement image widths;
//   - otherwise: kAssumedDisplacement image widths, because another surface, of unknown motion, has uncovered the
//     point.
// Fails: misses a surface much smaller than a cell that the raster image does not show and no ray hits.
#include "lib/bounds.glsl"
#include "lib/random.glsl"
#include "lib/sanitise.glsl"
#include "lib/times.glsl"
#include "mixin/limit.glsl"
#include "mixin/trace.glsl"

// Displacement assumed for a surface of unknown motion that only a validation ray has found, image widths. With a
// longer displacement, the first rays of the pass adaptive_times are closer together in time. On four scenes where
// validation rays contradict the motion of some cells, half this value gives up to 27 % fewer rays and up to 24 % more
// error; twice this value gives up to 35 % more rays and up to 13 % less error.
const float kAssumedDisplacement = 0.5;

// Shortest time, in exposures, that an offset is divided by to get a displacement. An error of 2^-8 px in the offset then
// causes an error of at most 1/16 px in the displacement.
const float kLeastTime = 1.0 / 16.0;

// True if a surface may reach this cell within the exposure. `offset`: offset of the surface's cell from this cell, in cells.
// `bounds`: bounds of the surface's displacement.
bool mayReach(vec4 bounds, ivec2 offset) {
  vec4 path = travelled(bounds, frame.shutter);
  vec2 side = vec2(params.cell_side), off = vec2(offset) * side;
  return all(lessThan(off + lowOf(path), side)) && all(greaterThan(off + highOf(path), -side));
}

// Smallest box that contains both boxes.
vec4 joined(vec4 a, vec4 b) { return vec4(min(lowOf(a), lowOf(b)), max(highOf(a), highOf(b))); }

// Bounds of the displacements of all surfaces that reach the cell, and of all texels that a gather in the cell reads, px over
// the exposure. A gather reads the texels that would reach the cell with the cell's own displacements.
vec4 boundsAround(ivec2 cell) {
  ivec2 last = pass_size() - 1;
  float reach_px = spreadFactor(frame.shutter) * reachPx();
  int around = min(int(ceil(reach_px / float(params.cell_side))), max(last.x, last.y));
  ivec2 low = max(cell - around - 1, ivec2(0)), high = min(cell + around + 1, last);
  vec4 own = texelFetch(bounds_tex, cell, 0), all_bounds = own;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      vec4 bounds = texelFetch(bounds_tex, ivec2(x, y), 0);
      ivec2 offset = ivec2(x, y) - cell;
      if (!isEmpty(bounds) && (mayReach(bounds, offset) || mayReach(own, offset))) all_bounds = joined(all_bounds, bounds);
    }
  }
  return all_bounds;
}

// True if the raster image shows the instance `id` (instance + 1) at most one pixel away from `at`.
bool shows(ivec2 at, uint id) {
  ivec2 last = ivec2(frame.size) - 1;
  for (int k = 0; k < 9; ++k) {
    ivec2 near = clamp(at + ivec2(k % 3, k / 3) - 1, ivec2(0), last);
    if (texelFetch(id_tex, near, 0).x == id) return true;
  }
  return false;
}

// True if validation ray `number` of the cell confirms the motion of its pixel. By the pixel's displacement, the
// surface at the pixel at the ray's time is at the position `expected` at the raster time. Two conditions must hold:
// - The point that the ray hits is at `expected` at the raster time, within half a pixel (for the rounding of a tap)
//   plus `apart_px`. If the ray hits the sky, this is not tested.
// - The raster image shows the hit instance (or the sky) at most one pixel away from `expected`.
// `found`: output; displacement of the hit point, px over the exposure, from its positions at the raster time and at
// the ray's time; 0 if the point is not in front of the camera at the raster time. For the sky: displacement of the
// pixel.
bool isConfirmed(ivec2 cell, uint number, out vec2 found) {
  ivec2 within = ivec2(stratified2(0u, number) * float(params.cell_side));
  ivec2 pixel = min(cell * params.cell_side + within, ivec2(frame.size) - 1);
  uint part = min(number * frame.slice_count / uint(max(params.validation_rays - 1, 1)), frame.slice_count - 1u);
  uint slice = SLICE_SAMPLE + part;
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = traceNearest(slice, ray, scene_cameras[slice].near, 3.0e38);
  vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  float t = sampleTime(int(part), int(frame.slice_count), 0.0);
  vec2 expected = vec2(pixel) + tapOffset(d, t);
  ivec2 texel = ivec2(roundSymmetric(expected));
  found = d;
  if (isHit(hit)) {
    vec3 place;
    bool is_placed = placeInRaster(hit, place);
    found = is_placed ? (vec2(pixel) - vec2(place)) / (abs(t) > kLeastTime ? t : kLeastTime) : vec2(0);
    if (!is_placed || lengthOf(vec2(place) - expected) > 0.5 + params.apart_px) return false;
  }
  return isInside(texel, ivec2(frame.size)) && shows(texel, isHit(hit) ? hit.instance + 1u : 0u);
}

// Displacement in the box `bounds` that is longest: the corner farthest from zero.
vec2 longestOf(vec4 bounds) {
  vec2 low = lowOf(bounds), high = highOf(bounds);
  return mix(low, high, greaterThan(abs(high), abs(low)));
}

void run(ivec2 cell) {
  vec4 bounds = boundsAround(cell);
  bool is_uniform = lengthOf(highOf(bounds) - lowOf(bounds)) <= params.apart_px;
  bool moves = spreadFactor(frame.shutter) * longestIn(bounds) > kStaticRadius;
  float certain = is_uniform ? moves ? 1.0 : 0.5 : 0.0;
  vec2 longest = longestOf(bounds), found;
  if (is_uniform) {
    count_checked(1u);
    for (int number = 0; number < params.validation_rays && certain > 0.25; ++number) {
      if (isConfirmed(cell, uint(number), found)) continue;
      certain = 0.25;
      count_mismatched(1u);
      vec2 unknown = vec2(kAssumedDisplacement * float(frame.size.x), 0);
      longest = lengthOf(found) > lengthOf(longest) + params.apart_px ? clampLength(found, unknown.x) : unknown;
    }
  }
  imageStore(certain_img, cell, vec4(certain));
  imageStore(longest_img, cell, vec4(longest, 0, 0));
}
