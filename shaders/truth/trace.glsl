// SPDX-License-Identifier: MIT
// Distributed ray tracing in time (Cook, Porter, Carpenter 1984): each pixel draws one of the iteration's scene times,
// traces the scene as it truly stands then, and adds the colour. Nothing is clamped, and no displacement is used.
// Regions, with f the instance seen at the capture:
//   inner   some sample sees a farther, different instance than f;
//   outer   some sample sees a nearer, different instance than f;
//   hidden  some sample sees a point that was occluded at the capture;
//   self    some sample sees a point of f itself that was occluded at the capture.
//
// Rays are spared where others have found the same.
//   What is at rest is found once on a ray; what moves has a tree of its own and is traced before it at each time.
//   Nothing is assumed.
//   Before a camera at rest, what all first samples of a pixel and its neighbours agree about (truth_agreement) holds
//   for the others: a triangle at rest, the shadows on a surface at rest, one colour of it; where nothing moves before
//   one colour, no more samples are taken. That assumes that nothing lies between all of these samples, of which there
//   are the more the more samples are asked for. The pixels of an audit trace it all the same, and count how often
//   something does.
#include "lib/audit.glsl"
#include "lib/mean.glsl"
#include "lib/reached.glsl"
#include "lib/regions.glsl"
#include "lib/seen.glsl"
#define STROBE_KEEPS_SHADOWS
#include "mixin/shade.glsl"

const float kFar = 3.0e38;
const bool kFrozen = PARAM_shading == shading_frozen;

bool sameTransform(SceneTransform a, SceneTransform b) {
  return a.row_x == b.row_x && a.row_y == b.row_y && a.row_z == b.row_z;
}

// Is the instance where it is at the capture? Unknown of what bends.
bool isPosedAlike(uint slice, uint instance) {
  return !bends(instance) && sameTransform(transformOf(slice, instance), transformOf(SLICE_CAPTURE, instance));
}

bool cameraIsStill(uint slice) {
  if (frame.camera_rests != 0u) return true;
  SceneCamera a = scene_cameras[slice], b = scene_cameras[SLICE_CAPTURE];
  return a.position == b.position && a.right == b.right && a.up == b.up && a.forward == b.forward &&
         a.half_extent == b.half_extent;
}

uvec4 seenAtRest(Hit hit) {
  return isHit(hit) ? uvec4(hit.instance + 2u, hit.geometry, hit.primitive, 0u) : uvec4(kSeenSky, 0u, 0u, 0u);
}

// Samples that contradict what they were taken to know.
bool misses = false;

// Was a point hidden from the capture's camera? The last 2^-12 of the way is the point's own surface. What is at rest
// before a camera at rest can be hidden by what moves alone.
bool wasOccluded(Hit hit) {
  vec3 capture_ws = positionOf(SLICE_CAPTURE, hit);
  SceneCamera camera = scene_cameras[SLICE_CAPTURE];
  vec3 position_vs = viewFromWorld(SLICE_CAPTURE, capture_ws);
  if (position_vs.z <= camera.near) return true;
  bool by_moving = PARAM_every_ray == 0 && frame.camera_rests != 0u && isAtRest(hit);
  if (by_moving && frame.moving_count == 0u) return false;
  Ray ray = cameraRay(SLICE_CAPTURE, pixelFromView(SLICE_CAPTURE, position_vs));
  uint mask = by_moving ? RAYS_TO_MOVING : RAYS_TO_ALL;
  return isHidden(SLICE_CAPTURE, mask, ray, camera.near, position_vs.z * (1.0 - 1.0 / 4096.0));
}

// `is_still`: nothing about the sample has moved, so the capture's own ray tells what was hidden behind what.
uint regionsOf(ivec2 pixel, uint slice, Ray ray, Hit hit, bool is_still, uint known) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  uint id = isHit(hit) ? hit.instance + 1u : 0u;
  uint found = 0u;
  bool farther = false;
  if (id != seen.x) {
    float before = kFar;
    if (seen.x != 0u)
      before = hitOnTriangle(SLICE_CAPTURE, cameraRay(SLICE_CAPTURE, samplePosition(pixel)), seen.x - 1u, seen.y, seen.z).t;
    float now = isHit(hit) ? hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive).t : kFar;
    farther = now > before;
    if (farther) found |= kRegionInner;
    if (now < before) found |= kRegionOuter;
  }
  if (is_still) return known | found | (farther && isHit(hit) ? kRegionHidden : 0u);
  uint asked = id == seen.x ? kRegionHidden | kRegionSelf : kRegionHidden;
  if (isHit(hit) && (known & asked) != asked && wasOccluded(hit)) found |= asked;
  return known | found;
}

// Does a triangle that one ray hits let others through?
bool hasHoles(uvec4 seen) {
#if FACT_alpha
  if (seen.x == kSeenSky) return false;
  return (scene_materials[geometryOf(instanceOf(seen), seen.y).material].flags & MATERIAL_ALPHA_MASK) != 0u;
#else
  return false;
#endif
}

// Means of even and odd iterations are kept apart: their difference tells how far off the mean of both can be.
void addSample(ivec2 pixel, vec3 color) {
  if ((frame.iteration & 1u) == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}

// All samples of the exposure at once: where nothing that moves can be seen, every sample is the first one.
void setSamples(ivec2 pixel, vec3 color) {
  imageStore(mean_a_img, pixel, vec4(color, float((frame.iteration_count + 1u) / 2u)));
  imageStore(mean_b_img, pixel, vec4(color, float(frame.iteration_count / 2u)));
}

// Does the pixel's tile take part in these samples?
bool takesPart(ivec2 pixel) {
#if HAS_budget
  return texelFetch(budget_tex, pixel / params.tile, 0).x >= params.least_budget;
#else
  return true;
#endif
}

// What samples before this one have found at rest, in this loop or the one before it.
uvec4 groundBefore(ivec2 pixel) {
  uvec4 ground = imageLoad(ground_img, pixel);
#if HAS_first_ground
  if (ground.x == kSeenNothing) ground = texelFetch(first_ground_tex, pixel, 0);
#endif
  return ground;
}

vec4 stillBefore(ivec2 pixel) {
  vec4 still = imageLoad(still_img, pixel);
#if HAS_first_still
  if (still.a == 0.0) still = texelFetch(first_still_tex, pixel, 0);
#endif
  return still;
}

uint regionsBefore(ivec2 pixel) {
  uint regions = imageLoad(regions_img, pixel).r;
#if HAS_first_regions
  regions |= texelFetch(first_regions_tex, pixel, 0).r;
#endif
  return regions;
}

// What a sample sees, given what is at rest on its ray, if that is known. Of hits at one distance the first in the scene
// counts. `t`: as the ray measures it.
Hit nearestHit(ivec2 pixel, uint slice, Ray ray, bool is_known, Hit ground, inout float t) {
  if (is_known && !isReached(pixel)) return ground;
  uint mask = is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  float end = is_known && isHit(ground) ? uintBitsToFloat(floatBitsToUint(t) + 1u) : kFar;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, end, NO_INSTANCE, NO_INSTANCE);
  if (is_known && (!isHit(hit) || (hit.t == t && hit.instance > ground.instance))) return ground;
  t = hit.t;
  // As raster computes it, which does not depend on the device: what stands still is as the capture sees it, bit for bit.
  return isHit(hit) ? hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive) : hit;
}

vec3 colorOf(ivec2 pixel, uint slice, Ray ray, Hit hit, bool spares_rays) {
  if (!isHit(hit)) return environment(ray.direction);
  uvec2 known = uvec2(0u);
#if HAS_known_shadows
  if (kFrozen && frame.camera_rests != 0u && isAtRest(hit)) known = texelFetch(known_shadows_tex, pixel, 0).xy;
#endif
  if (spares_rays) {
    known_free = known.x;
    known_blocked = known.y;
  }
  vec3 color = shade(kFrozen ? SLICE_CAPTURE : slice, hit);
  misses = misses || ((known.x & found_blocked) | (known.y & found_free)) != 0u;
  return color;
}

// What is at rest, for the agreement of samples, and for those after this one.
void note(ivec2 pixel, Hit hit, float ground_t, vec3 color) {
  uvec4 ground = imageLoad(ground_img, pixel), seen = seenAtRest(hit);
  bool is_first = ground.x == kSeenNothing;
  if (is_first) ground = uvec4(seen.xyz, floatBitsToUint(ground_t));
  else if (ground.xy != seen.xy) ground = uvec4(kSeenSeveral, 0u, 0u, 0u);
  else if (ground.z != seen.z) ground.z = kSeenSeveral;
  imageStore(ground_img, pixel, ground);
  vec4 still = imageLoad(still_img, pixel);
  imageStore(still_img, pixel, withSample(still, color));
#if PARAM_keeps_notes
  vec3 change = abs(color - still.rgb);
  float unlike = max(change.r, max(change.g, change.b)) / max(max(still.r, max(still.g, still.b)), 1e-6);
  if (!is_first) imageStore(unlike_img, pixel, vec4(max(unlike, imageLoad(unlike_img, pixel).x)));
  uvec2 found = uvec2(found_free, found_blocked), shadows = imageLoad(shadows_img, pixel).xy;
  imageStore(shadows_img, pixel, uvec4(is_first ? found : shadows & found, 0u, 0u));
#endif
}

void run(ivec2 pixel) {
  if (!takesPart(pixel)) return;
  uint index = uint(pixel.y) * frame.size.x + uint(pixel.x);
  uint number = frame.part + uint(params.taken);
  uint slice = TIME_SLICE;
  if (frame.slice_count > 1u) slice += randomUint(index, number, 0u) % frame.slice_count;
  vec2 position_px = samplePosition(pixel);
#if PARAM_pixel == pixel_box
  position_px = vec2(pixel) + stratified2(index, number);
#endif
  Ray ray = cameraRay(slice, position_px);
  bool audited = isAudited(pixel, params.audit);
  bool spares_rays = PARAM_every_ray == 0 && !audited;
  // Before a camera at rest, rays through centres are one ray.
  bool one_ray = PARAM_every_ray == 0 && kFrozen && PARAM_pixel == pixel_centre && frame.camera_rests != 0u;

  // Where all colours are one, and nothing comes, the first samples are enough.
  bool is_even = false;
#if HAS_even_color
  vec4 even = texelFetch(even_color_tex, pixel, 0);
  is_even = kFrozen && even.a != 0.0 && spares_rays && !one_ray && frame.camera_rests != 0u;
  if (is_even && !isReached(pixel)) return;
#else
  vec4 even = vec4(0);
#endif

  // What is at rest on the ray, where that is known.
  Hit ground = noHit();
  float t = kFar;
  uvec4 found = one_ray ? groundBefore(pixel) : uvec4(0u);
  bool is_found = isOneSurface(found), is_known = is_found;
  if (is_found && found.x != kSeenSky) {
    ground = Hit(instanceOf(found), found.y, found.z, vec2(0), 0.0, true);
    t = uintBitsToFloat(found.w);
  }
#if HAS_known_hit
  uvec4 agreed = !is_found && frame.camera_rests != 0u ? texelFetch(known_hit_tex, pixel, 0) : uvec4(0u);
  bool is_agreed = isOneTriangle(agreed) && !hasHoles(agreed);
  if (is_agreed && spares_rays) {
    is_known = true;
    if (agreed.x != kSeenSky) ground = hitOnTriangle(slice, ray, instanceOf(agreed), agreed.y, agreed.z);
    if (isHit(ground)) t = ground.t;
  }
#endif
  Hit hit = nearestHit(pixel, slice, ray, is_known, ground, t);
  bool at_rest = isAtRest(hit);
  vec3 color;
  if (is_found && at_rest) color = stillBefore(pixel).rgb;
  else if (is_even && at_rest) color = even.rgb;
  else color = colorOf(pixel, slice, ray, hit, spares_rays);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  if (!is_known && at_rest && (PARAM_keeps_notes != 0 || one_ray)) note(pixel, hit, t, color);
#if HAS_known_hit
  misses = misses || (is_agreed && !is_known && at_rest && agreed.xyz != seenAtRest(hit).xyz);
#endif
#if PARAM_once_where_still
  if (isReached(pixel)) addSample(pixel, color);
  else setSamples(pixel, color);
#else
  addSample(pixel, color);
#endif

#if PARAM_mark_regions
  uint known = regionsBefore(pixel);
  bool is_still = PARAM_pixel == pixel_centre && kFrozen && cameraIsStill(slice) &&
                  (at_rest || isPosedAlike(slice, hit.instance));
  uint regions = regionsOf(pixel, slice, ray, hit, is_still, known);
  if (regions != known) imageStore(regions_img, pixel, uvec4(regions, 0u, 0u, 0u));
#endif
#if HAS_known_hit
  if (audited) count_audited(1u);
  if (audited && misses) count_missed(1u);
#endif
}
