// SPDX-License-Identifier: MIT
// Adds one time sample to each pixel's mean, by distributed ray tracing in time (Cook, Porter, Carpenter 1984).
// In:  `hit`:     raster layer: instance + 1 (0 = sky), geometry, primitive
//      `listed`:  pixels to run over; absent: all
//      `sure`:    per shadow tile: lights visible from all of the tile's surfaces, and blocked from all (`shadow_shafts`)
//      `known_hit`, `known_shadows`, `even_color`: consensus of the first samples (truth/agreement.glsl); absent: none
//      `first_ground`, `first_still`, `first_regions`: `ground`, `still` and `regions` of the samples before this loop; absent:
//                 none
// Out: `mean_a`, `mean_b`: updated, like all outputs; rgb: mean linear radiance of each half of the samples; alpha: their
//                 number
//      `regions`: bits 1 inner, 2 hidden, 4 outer, 8 self (lib/regions.glsl)
//      `ground`:  surface that the static hits have in common, with its distance; for `pixel` = box, of the moving hits if none
//                 is static (lib/seen.glsl)
//      `still`:   rgb: mean linear radiance of the static hits; alpha: their number
//      `unlike`:  largest difference of a static sample's radiance from the mean before it, as a share of that mean
//      `shadows`: visible and blocked lights of two instances (lib/seen.glsl)
// Method: draw one of the iteration's times, trace the scene as posed then, shade the hit, add the radiance without clamping.
//      Exact shortcuts: static surfaces are found once per ray; moving surfaces have a tree of their own. Assumed: a consensus
//      of the first samples holds for the others (docs/truth.md lists the rays that each consensus saves).
// Fails: a surface between all first samples is missed. The share `audit` of the pixel blocks traces every ray and counts
//      contradictions.
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

// True if the instance has the pose of the raster time. False for deformed instances, whose vertices are not compared.
bool isPosedAlike(uint slice, uint instance) {
  return !bends(instance) && sameTransform(transformOf(slice, instance), transformOf(SLICE_CAPTURE, instance));
}

bool cameraIsStill(uint slice) {
  if (frame.camera_rests != 0u) return true;
  SceneCamera a = scene_cameras[slice], b = scene_cameras[SLICE_CAPTURE];
  return a.position == b.position && a.right == b.right && a.up == b.up && a.forward == b.forward &&
         a.half_extent == b.half_extent;
}

// A hit in the form of lib/seen.glsl.
uvec4 seenAs(Hit hit) {
  return isHit(hit) ? uvec4(hit.instance + 2u, hit.geometry, hit.primitive, 0u) : uvec4(kSeenSky, 0u, 0u, 0u);
}

// True if an audited sample contradicts the consensus or the known shadows.
bool misses = false;

// True for a moving surface, with a static camera.
bool isMoving(uvec4 seen) {
  return frame.camera_rests != 0u && isOneSurface(seen) && seen.x != kSeenSky && instanceAt(instanceOf(seen)).moves != 0u;
}

// True if the point was occluded at the raster time or behind the near plane. The last 2^-12 of the way is not tested: it holds
// the point's own surface. With a static camera only moving surfaces occlude a static point, and nothing occludes a rigid
// instance in front of everything.
bool wasOccluded(ivec2 pixel, Hit hit) {
  bool by_moving = PARAM_every_ray == 0 && frame.camera_rests != 0u && isAtRest(hit);
  if (by_moving && !isReachedAt(SLICE_CAPTURE, pixel)) return false;
  vec3 capture_ws = positionOf(SLICE_CAPTURE, hit);
  SceneCamera camera = scene_cameras[SLICE_CAPTURE];
  vec3 position_vs = viewFromWorld(SLICE_CAPTURE, capture_ws);
  if (position_vs.z <= camera.near) return true;
  bool is_foremost = PARAM_every_ray == 0 && !by_moving && (instanceAt(hit.instance).path & PATH_COVERED) == 0u;
  if (frame.camera_rests != 0u && is_foremost) return false;
  Ray ray = cameraRay(SLICE_CAPTURE, pixelFromView(SLICE_CAPTURE, position_vs));
  uint mask = by_moving ? RAYS_TO_MOVING : RAYS_TO_ALL;
  return isHidden(SLICE_CAPTURE, mask, ray, camera.near, position_vs.z * (1.0 - 1.0 / 4096.0));
}

// Pixel that shows the point at the raster time; false if the point is outside the image or the near plane.
bool isInCapture(Hit hit, out ivec2 place) {
  vec3 position_vs = viewFromWorld(SLICE_CAPTURE, positionOf(SLICE_CAPTURE, hit));
  vec2 place_px = pixelFromView(SLICE_CAPTURE, position_vs);
  place = ivec2(0);
  if (!(position_vs.z > scene_cameras[SLICE_CAPTURE].near)) return false;
  if (!all(greaterThanEqual(place_px, vec2(0))) || !all(lessThan(place_px, vec2(frame.size)))) return false;
  place = ivec2(place_px);
  return true;
}

// Regions of occluded points that this sample may add to the pixel; 0 if the pixel has them already.
uint askedRegions(ivec2 pixel, Hit hit, uint known) {
  if (!isHit(hit)) return 0u;
  uint asked = hit.instance + 1u == texelFetch(hit_tex, pixel, 0).x ? kRegionHidden | kRegionSelf : kRegionHidden;
  return (known & asked) != asked ? asked : 0u;
}

// Regions of a sample. `is_still`: neither camera nor instance has moved, so a comparison with the depth of the raster sample
// replaces the occlusion test. `hidden`: otherwise, the regions of an occluded point; 0 if it is visible at the raster time.
uint regionsOf(ivec2 pixel, uint slice, Ray ray, Hit hit, bool is_still, uint hidden) {
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
  if (is_still) hidden = farther && isHit(hit) ? kRegionHidden : 0u;
  return found | hidden;
}

// True if some rays pass through the triangle, because alpha cuts holes into it.
bool hasHoles(uvec4 seen) {
#if FACT_alpha
  if (seen.x == kSeenSky) return false;
  return (scene_materials[geometryOf(instanceOf(seen), seen.y).material].flags & MATERIAL_ALPHA_MASK) != 0u;
#else
  return false;
#endif
}

// Adds the sample to the mean of its half. The difference of the halves gives the error of their mean.
void addSample(ivec2 pixel, uint number, vec3 color) {
  uint half_of = PARAM_pixel == pixel_box ? stratifiedHalf(number) : frame.iteration & 1u;
  if (half_of == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}

// Sets all samples of the exposure at once, for pixels where no moving surface can be visible.
void setSamples(ivec2 pixel, vec3 color) {
  imageStore(mean_a_img, pixel, vec4(color, float((frame.iteration_count + 1u) / 2u)));
  imageStore(mean_b_img, pixel, vec4(color, float(frame.iteration_count / 2u)));
}

// Static surface that earlier samples hit, in this loop or in the one before it.
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

// Intersection of a ray with the surface of the consensus; a miss if the ray passes beside it or through a hole.
Hit hitOnAgreed(uint slice, Ray ray, uvec4 agreed, out float t) {
  uint instance = instanceOf(agreed);
  bool one_triangle = isOneTriangle(agreed) && !hasHoles(agreed) && !isMoving(agreed);
  Hit hit = Hit(instance, agreed.y, agreed.z, vec2(0), 0.0, true);
  if (!one_triangle) hit = traceInstance(slice, instance, ray, scene_cameras[slice].near, kFar);
  t = hit.t;
  if (!isHit(hit)) return hit;
  hit = hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  if (one_triangle) t = hit.t;
  return hit;
}

// Surface on a sample's ray that is known without tracing the whole scene.
struct Known {
  bool is_known, is_found;  // is_found: static, hit by an earlier sample on the same ray
  Hit hit;
  float t;       // as the ray measures it
  uvec4 agreed;  // consensus of the first samples
  Hit taken;     // intersection of this ray with `agreed`
};

Known knownOn(ivec2 pixel, uint slice, Ray ray, bool one_ray, bool spares_rays) {
  Known known = Known(false, false, noHit(), kFar, uvec4(kSeenNothing), noHit());
  uvec4 found = one_ray ? groundBefore(pixel) : uvec4(kSeenNothing);
  known.is_found = known.is_known = isOneSurface(found);
  if (known.is_found && found.x != kSeenSky) {
    known.hit = Hit(instanceOf(found), found.y, found.z, vec2(0), 0.0, true);
    known.t = uintBitsToFloat(found.w);
  }
#if HAS_known_hit
  if (known.is_found || frame.camera_rests == 0u) return known;
  known.agreed = texelFetch(known_hit_tex, pixel, 0);
  if (!isOneSurface(known.agreed)) return known;
  float t = kFar;
  bool is_sky = known.agreed.x == kSeenSky;
  if (!is_sky && (spares_rays || isMoving(known.agreed))) known.taken = hitOnAgreed(slice, ray, known.agreed, t);
  known.is_known = spares_rays && (is_sky || isHit(known.taken));
  if (known.is_known) known.hit = known.taken;
  if (isHit(known.hit)) known.t = t;
#endif
  return known;
}

// True if a fully traced sample hits another surface than the consensus predicts.
bool contradicts(Known known, Hit hit) {
  if (!isOneSurface(known.agreed)) return false;
  uvec4 seen = seenAs(hit);
  if (isMoving(known.agreed)) return isHit(known.taken) && seenAs(known.taken) != seen;
  if (!isOneTriangle(known.agreed)) seen.z = known.agreed.z;
  return isAtRest(hit) && known.agreed.xyz != seen.xyz;
}

// Known shadows of a point, in the form of lib/seen.glsl. `is_shown`: the first samples hit its triangle at the raster time.
uint shadowsAt(ivec2 pixel, Hit hit, out bool is_shown) {
  is_shown = false;
  uint shadows = 0u;
#if HAS_known_hit
  if (!kFrozen || !isHit(hit)) return 0u;
  ivec2 place = pixel;
  bool camera_rests = frame.camera_rests != 0u;
  if (camera_rests && !isAtRest(hit)) return 0u;
  if (!camera_rests && !isInCapture(hit, place)) return 0u;
  shadows = shadowsOf(texelFetch(known_shadows_tex, place, 0), hit.instance);
  uvec4 shown = texelFetch(known_hit_tex, place, 0);
  is_shown = !camera_rests && isOneTriangle(shown) && shown.xyz == seenAs(hit).xyz;
#endif
  return shadows;
}

// Nearest hit on a sample's ray: the static hit `ground` if it is known, or a moving surface in front. At equal distance the
// first instance of the scene wins. `t`: distance as the ray computes it.
Hit nearestHit(ivec2 pixel, uint slice, Ray ray, bool is_known, Hit ground, inout float t) {
  if (is_known && (!isAtRest(ground) || !isReachedAt(slice, pixel))) return ground;
  uint mask = is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  float end = is_known && isHit(ground) ? uintBitsToFloat(floatBitsToUint(t) + 1u) : kFar;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, end, NO_INSTANCE, NO_INSTANCE);
  if (is_known && (!isHit(hit) || (hit.t == t && hit.instance > ground.instance))) return ground;
  t = hit.t;
  // Intersected again as for the raster layer: independent of the device, and bit for bit equal for static surfaces.
  return isHit(hit) ? hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive) : hit;
}

// Sets the lights known to be visible (x) and blocked (y).
void takeAsKnown(uvec2 lights) {
  known_free = found_free = lights.x;
  known_blocked = found_blocked = lights.y;
}

// `known`: lights that are visible (x) and blocked (y).
vec3 colorOf(uint slice, Ray ray, Hit hit, uvec2 known, bool spares_rays) {
  if (!isHit(hit)) return environment(ray.direction);
  takeAsKnown(spares_rays ? known : uvec2(0u));
  vec3 color = shade(kFrozen ? SLICE_CAPTURE : slice, hit);
  misses = misses || ((known.x & found_blocked) | (known.y & found_free)) != 0u;
  return color;
}

// The surfaces of earlier samples, combined with one more.
uvec4 withSeen(uvec4 before, uvec4 seen) {
  if (before.x == kSeenNothing) return seen;
  if (before.xy != seen.xy) return uvec4(kSeenSeveral, 0u, 0u, 0u);
  if (before.z != seen.z) before.z = kSeenSeveral;
  return before;
}

// Records a moving surface, unless a sample has hit a static one.
void noteMoving(ivec2 pixel, Hit hit) {
  uvec4 before = imageLoad(ground_img, pixel);
  if (before.x == kSeenNothing || isMoving(before)) imageStore(ground_img, pixel, withSeen(before, seenAs(hit)));
}

// Records a static surface, or a surface at the raster time, and its shadows, for the consensus and for later samples. False
// for the first such sample of the pixel.
bool noteSurface(ivec2 pixel, Hit hit, float ground_t) {
  uvec4 before = imageLoad(ground_img, pixel);
  bool is_first = before.x == kSeenNothing || isMoving(before);
  if (is_first) before = uvec4(kSeenNothing);
  imageStore(ground_img, pixel, withSeen(before, uvec4(seenAs(hit).xyz, floatBitsToUint(ground_t))));
#if PARAM_keeps_notes
  if (isHit(hit)) {
    uint shadows = shadowsFrom(uvec2(found_free, found_blocked));
    imageStore(shadows_img, pixel, withShadows(imageLoad(shadows_img, pixel), hit.instance, shadows));
  }
#endif
  return !is_first;
}

void note(ivec2 pixel, Hit hit, float ground_t, vec3 color) {
  bool was_seen = noteSurface(pixel, hit, ground_t);
  vec4 still = imageLoad(still_img, pixel);
  imageStore(still_img, pixel, withSample(still, color));
#if PARAM_keeps_notes
  vec3 change = abs(color - still.rgb);
  float unlike = max(change.r, max(change.g, change.b)) / max(max(still.r, max(still.g, still.b)), 1e-6);
  if (was_seen) imageStore(unlike_img, pixel, vec4(max(unlike, imageLoad(unlike_img, pixel).x)));
#endif
}

// Lights visible (x) and blocked (y) from the whole shadow tile, if the raster image shows the hit: its triangle at the pixel,
// or for samples all over the pixel its surface at the pixel and at the eight around it.
uvec2 sureShadows(ivec2 pixel, Hit hit) {
  uvec2 sure = uvec2(0u);
#if HAS_sure
  if (!isHit(hit)) return sure;
  uvec3 seen = uvec3(hit.instance + 1u, hit.geometry, hit.primitive);
#if PARAM_pixel == pixel_box
  bool is_shown = true;
  ivec2 last = textureSize(hit_tex, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    is_shown = is_shown && texelFetch(hit_tex, at, 0).xy == seen.xy;
  }
#else
  bool is_shown = texelFetch(hit_tex, pixel, 0).xyz == seen;
#endif
  if (is_shown) sure = texelFetch(sure_tex, pixel / params.shadow_tile, 0).xy;
#endif
  return sure;
}

#if PARAM_surveys
// Records the surface at the raster time at a position in the pixel, and its shadows. Its radiance is not used, because the
// camera moves.
void survey(ivec2 pixel, vec2 position_px) {
  Ray ray = cameraRay(SLICE_CAPTURE, position_px);
  float t = kFar;
  Hit hit = nearestHit(pixel, SLICE_CAPTURE, ray, false, noHit(), t);
  takeAsKnown(sureShadows(pixel, hit));
  if (isHit(hit)) findShadows(SLICE_CAPTURE, hit);
  noteSurface(pixel, hit, t);
}
#endif

void run(ivec2 pixel) {
  uint index = uint(pixel.y) * frame.size.x + uint(pixel.x);
  uint number = PARAM_in_turn != 0 ? frame.iteration : frame.part;
  uint slice = TIME_SLICE;
  if (frame.slice_count > 1u) slice += randomUint(index, number, 0u) % frame.slice_count;
  vec2 position_px = samplePosition(pixel);
#if PARAM_pixel == pixel_box
  position_px = vec2(pixel) + stratified2(index, number);
#endif
  Ray ray = cameraRay(slice, position_px);
  bool audited = isAudited(pixel / kAuditBlock, params.audit);
  bool spares_rays = PARAM_every_ray == 0 && !audited;
  // With a static camera, all rays through the pixel's centre are one ray.
  bool one_ray = PARAM_every_ray == 0 && kFrozen && PARAM_pixel == pixel_centre && frame.camera_rests != 0u;

  bool is_even = false;
#if HAS_even_color
  vec4 even = texelFetch(even_color_tex, pixel, 0);
  is_even = kFrozen && even.a != 0.0 && spares_rays && !one_ray && frame.camera_rests != 0u;
#else
  vec4 even = vec4(0);
#endif

  Known known = knownOn(pixel, slice, ray, one_ray, spares_rays);
  float t = known.t;
  Hit hit = nearestHit(pixel, slice, ray, known.is_known, known.hit, t);
  bool at_rest = isAtRest(hit);
  misses = !spares_rays && contradicts(known, hit);

  // Occlusion at the raster time: tested for regions, and with a moving camera if the known shadows save more than one ray.
  uint regions = 0u, asked = 0u;
  bool is_still = false, is_shown;
#if PARAM_mark_regions
  regions = regionsBefore(pixel);
  is_still = PARAM_pixel == pixel_centre && kFrozen && cameraIsStill(slice) &&
             (at_rest || isPosedAlike(slice, hit.instance));
  if (!is_still) asked = askedRegions(pixel, hit, regions);
#endif
  uint shadows = shadowsAt(pixel, hit, is_shown);
  bool looks = !(is_shown && spares_rays) && (asked != 0u || (frame.camera_rests == 0u && countLights(shadows) > 1));
  bool is_hidden = looks && wasOccluded(pixel, hit);
  misses = misses || (is_shown && is_hidden);
  if (frame.camera_rests == 0u && (looks ? is_hidden : !is_shown)) shadows = 0u;

  bool is_sure = kFrozen && frame.camera_rests != 0u && at_rest && shadows == 0u;
  vec3 color;
  if (known.is_found && at_rest) color = stillBefore(pixel).rgb;
  else if (is_even && at_rest) color = even.rgb;
  else color = colorOf(slice, ray, hit, is_sure ? sureShadows(pixel, hit) : lightsOf(shadows), spares_rays);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  bool notes = frame.camera_rests != 0u && !known.is_known && (PARAM_keeps_notes != 0 || one_ray);
  if (notes && at_rest) note(pixel, hit, t, color);
  else if (notes && PARAM_pixel == pixel_box) noteMoving(pixel, hit);
#if PARAM_once_where_still
  if (isReached(pixel)) addSample(pixel, number, color);
  else setSamples(pixel, color);
#else
  addSample(pixel, number, color);
#endif

#if PARAM_mark_regions
  uint now = regions | regionsOf(pixel, slice, ray, hit, is_still, is_hidden ? asked : 0u);
  if (now != regions) imageStore(regions_img, pixel, uvec4(now, 0u, 0u, 0u));
#endif
#if HAS_known_hit
  if (audited) count_audited(1u);
  if (audited && misses) count_missed(1u);
#endif
#if PARAM_surveys
  if (kFrozen && frame.camera_rests == 0u) survey(pixel, vec2(pixel) + stratified2(index, number));
#endif
}
