// SPDX-License-Identifier: MIT
// Adds one time sample to each pixel's mean, by distributed ray tracing in time (Cook, Porter, Carpenter 1984). To skip
// rays, ground truth runs this pass in two loops: the first samples, then the other samples, which use the consensus of
// the first.
// In:  `hit`: raster layer: instance + 1 (0 = sky), geometry, primitive
//      `pixel_list`: pixels to sample; absent: all pixels
//      `light_visibility`: per shadow tile, bits of the lights visible (x) and blocked (y) from all its surfaces; absent: none
//      `known_hit`, `known_shadows`, `even_color`: consensus of the first samples (truth/sample_consensus.glsl), in the
//        second loop; absent: none
//      `first_static`, `first_static_mean`, `first_regions`: outputs `static_background`, `static_mean` and `regions`
//        of the first loop, in the second loop; absent: none
// Out: all outputs are updated. `mean_a`, `mean_b`: rgb: mean linear radiance of each half of the samples; alpha: their number
//      `regions`: regions for the report of errors: bits 1 inner, 2 hidden, 4 outer, 8 self (lib/regions.glsl)
//      `static_background`: common surface of the static hits, with its distance (lib/consensus.glsl). If no hit is
//        static, `pixel` = box stores the common surface of the moving hits instead
//      `static_mean`: rgb: mean linear radiance of the static hits; alpha: number of static hits
//      `contrast`: largest difference of a static sample's radiance from the mean before the sample, as a share of that mean
//      `shadows`: visible and blocked lights on two instances (lib/consensus.glsl)
// Method: draw one of the iteration's times, trace the scene as posed at that time, shade the hit, and add the radiance without
//   clamping. Two shortcuts are exact: the static surface on a ray is found once, and rays then test only the moving surfaces,
//   which have their own tree. One shortcut is an assumption: later samples agree with the consensus of the first samples
//   (docs/truth.md).
// Fails: misses a surface that lies between all first samples. To measure this, the share `validation_share` of the pixel
//   blocks traces every ray and counts contradictions.
#include "lib/validation.glsl"
#include "lib/mean.glsl"
#include "lib/moving_rect.glsl"
#include "lib/regions.glsl"
#include "lib/consensus.glsl"
#define STROBE_KEEPS_SHADOWS
#include "mixin/shade.glsl"

const float kFar = 3.0e38;
const bool kFrozen = PARAM_shading == shading_frozen;

// True if two transforms are equal, bit for bit.
bool sameTransform(SceneTransform a, SceneTransform b) {
  return a.row_x == b.row_x && a.row_y == b.row_y && a.row_z == b.row_z;
}

// True if the instance has the same pose at `slice` as at the raster time. False for deformed instances, because their vertices
// are not compared.
bool hasRasterPose(uint slice, uint instance) {
  return !deforms(instance) && sameTransform(transformOf(slice, instance), transformOf(SLICE_RASTER, instance));
}

// True if the camera has the same pose and field of view at `slice` as at the raster time.
bool cameraIsStill(uint slice) {
  if (frame.camera_rests != 0u) return true;
  SceneCamera a = scene_cameras[slice], b = scene_cameras[SLICE_RASTER];
  return a.position == b.position && a.right == b.right && a.up == b.up && a.forward == b.forward &&
         a.half_extent == b.half_extent;
}

// Ids of a hit in the form of lib/consensus.glsl: instance + 2, geometry, triangle.
uvec4 idsOf(Hit hit) {
  return isHit(hit) ? uvec4(hit.instance + 2u, hit.geometry, hit.primitive, 0u) : uvec4(kSkySurface, 0u, 0u, 0u);
}

// True if the current sample contradicts the consensus: it hits another surface than the first samples agree on, or has other
// shadows. Computed only for samples that trace all rays, for validation.
bool is_mismatch = false;

// True if the camera is static and `ids`, a summary of the hits of several samples (lib/consensus.glsl), has a single
// surface, which belongs to a moving instance. Later hits on static surfaces replace such a summary. Always false with
// a moving camera: a summary then holds hits of rays at the raster time. Hits on moving instances are then as good as
// hits on static ones, and nothing replaces them.
bool isMoving(uvec4 ids) {
  return frame.camera_rests != 0u && isOneSurface(ids) && ids.x != kSkySurface && instanceAt(instanceOf(ids)).moves != 0u;
}

// True if the hit point is occluded at the raster time, or behind the near plane at that time. The ray ends 2^-12 of
// the distance before the point, because the point's own surface lies there. A static camera saves work in two cases.
// For a static point, the ray tests only moving surfaces; no ray is traced if no moving surface can be at the pixel. A
// point on a rigid instance that is in front of all others needs no ray.
bool wasOccluded(ivec2 pixel, Hit hit) {
  bool by_moving = PARAM_every_ray == 0 && frame.camera_rests != 0u && isAtRest(hit);
  if (by_moving && !isReachedAt(SLICE_RASTER, pixel)) return false;
  vec3 raster_ws = positionOf(SLICE_RASTER, hit);
  SceneCamera camera = scene_cameras[SLICE_RASTER];
  vec3 position_vs = viewFromWorld(SLICE_RASTER, raster_ws);
  if (position_vs.z <= camera.near) return true;
  bool is_foremost = PARAM_every_ray == 0 && !by_moving && (instanceAt(hit.instance).path & PATH_MAY_BE_OCCLUDED) == 0u;
  if (frame.camera_rests != 0u && is_foremost) return false;
  Ray ray = cameraRay(SLICE_RASTER, pixelFromView(SLICE_RASTER, position_vs));
  uint mask = by_moving ? RAYS_TO_MOVING : RAYS_TO_ALL;
  return isHidden(SLICE_RASTER, mask, ray, camera.near, position_vs.z * (1.0 - 1.0 / 4096.0));
}

// True if the hit point is inside the image and beyond the near plane at the raster time. `place`: pixel that contains the
// point at that time.
bool isInRaster(Hit hit, out ivec2 place) {
  vec3 position_vs = viewFromWorld(SLICE_RASTER, positionOf(SLICE_RASTER, hit));
  vec2 place_px = pixelFromView(SLICE_RASTER, position_vs);
  place = ivec2(0);
  if (!(position_vs.z > scene_cameras[SLICE_RASTER].near)) return false;
  if (!all(greaterThanEqual(place_px, vec2(0))) || !all(lessThan(place_px, vec2(frame.size)))) return false;
  place = ivec2(place_px);
  return true;
}

// Bits of the report regions that the pixel gets if the hit point is occluded at the raster time; 0 if the pixel has all of
// these bits already, so that no occlusion test is needed. `known`: bits that the pixel has.
uint wantedRegions(ivec2 pixel, Hit hit, uint known) {
  if (!isHit(hit)) return 0u;
  uint wanted = hit.instance + 1u == hit_at(pixel).x ? kRegionHidden | kRegionSelf : kRegionHidden;
  return (known & wanted) != wanted ? wanted : 0u;
}

// Bits of the report regions of a sample. They compare the hit with the surface that the raster layer shows at the
// pixel. `is_static`: true if neither camera nor instance has moved since the raster time; a comparison of depths then
// replaces the occlusion test. `hidden`: used if `is_static` is false; bits to set because the point is occluded at the
// raster time, or 0 if the point is visible then.
uint regionsOf(ivec2 pixel, uint slice, Ray ray, Hit hit, bool is_static, uint hidden) {
  uvec4 ids = hit_at(pixel);
  uint id = isHit(hit) ? hit.instance + 1u : 0u;
  uint found = 0u;
  bool farther = false;
  if (id != ids.x) {
    float before = kFar;
    if (ids.x != 0u)
      before = hitOnTriangle(SLICE_RASTER, cameraRay(SLICE_RASTER, samplePosition(pixel)), ids.x - 1u, ids.y, ids.z).t;
    float now = isHit(hit) ? hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive).t : kFar;
    farther = now > before;
    if (farther) found |= kRegionInner;
    if (now < before) found |= kRegionOuter;
  }
  if (is_static) hidden = farther && isHit(hit) ? kRegionHidden : 0u;
  return found | hidden;
}

// True if rays may pass through the triangle `ids` (form of lib/consensus.glsl), because its material has alpha cut-outs.
bool hasHoles(uvec4 ids) {
#if FACT_alpha
  if (ids.x == kSkySurface) return false;
  return (scene_materials[geometryOf(instanceOf(ids), ids.y).material].flags & MATERIAL_ALPHA_MASK) != 0u;
#else
  return false;
#endif
}

// Adds sample `number` to the mean of its half of the samples. The difference of the two halves gives the error of their mean.
void addSample(ivec2 pixel, uint number, vec3 color) {
  uint half_of = PARAM_pixel == pixel_box ? stratifiedHalf(number) : frame.iteration & 1u;
  if (half_of == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}

// Sets the means of both halves as if all samples of the loop had this colour, for pixels where no moving surface can be
// visible.
void setSamples(ivec2 pixel, vec3 color) {
  imageStore(mean_a_img, pixel, vec4(color, float((frame.iteration_count + 1u) / 2u)));
  imageStore(mean_b_img, pixel, vec4(color, float(frame.iteration_count / 2u)));
}

// Static surface that earlier samples of the pixel hit, in this loop or in the loop of the first samples (form of
// lib/consensus.glsl); kNoSurface if no sample hit a static surface.
uvec4 staticBefore(ivec2 pixel) {
  uvec4 static_background = imageLoad(static_background_img, pixel);
  return static_background.x == kNoSurface ? first_static_at(pixel) : static_background;
}

// Mean linear radiance (rgb) of the earlier samples of the pixel that hit a static surface, and their number (alpha).
// Only samples of this loop are averaged. If none of these hit a static surface, the first samples are averaged
// instead.
vec4 staticMeanBefore(ivec2 pixel) {
  vec4 static_mean = imageLoad(static_mean_img, pixel);
  return static_mean.a == 0.0 ? first_static_mean_at(pixel) : static_mean;
}

// Bits of the report regions that earlier samples of the pixel have set, in this loop or in the loop of the first samples.
uint regionsBefore(ivec2 pixel) { return imageLoad(regions_img, pixel).r | first_regions_at(pixel).r; }

// Intersection of a ray with the surface that the first samples agree on (`consensus`, form of lib/consensus.glsl). The result
// is a miss if the ray passes beside the surface or through a hole. `t`: distance along the ray.
Hit hitOnConsensus(uint slice, Ray ray, uvec4 consensus, out float t) {
  uint instance = instanceOf(consensus);
  bool one_triangle = isOneTriangle(consensus) && !hasHoles(consensus) && !isMoving(consensus);
  Hit hit = Hit(instance, consensus.y, consensus.z, vec2(0), 0.0, true);
  if (!one_triangle) hit = traceInstance(slice, instance, ray, scene_cameras[slice].near, kFar);
  t = hit.t;
  if (!isHit(hit)) return hit;
  hit = hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  if (one_triangle) t = hit.t;
  return hit;
}

// Surface on a sample's ray that is known from earlier samples, so that the ray need not test the whole scene.
struct Known {
  bool is_known, is_found;  // is_known: `hit` is valid; is_found: an earlier sample on this ray hit this static surface
  Hit hit;
  float t;                  // distance along the ray, as traversal computes it
  uvec4 consensus;          // surface that the first samples agree on (form of lib/consensus.glsl)
  Hit consensus_hit;        // intersection of this ray with the surface `consensus`
};

// Surface known on the ray. `one_ray`: all samples of the pixel have one ray, so an earlier hit on a static surface is valid
// for this sample. `spares_rays`: false for samples that trace all rays; the consensus is then compared with the traced hit,
// but not used.
Known knownOn(ivec2 pixel, uint slice, Ray ray, bool one_ray, bool spares_rays) {
  Known known = Known(false, false, noHit(), kFar, uvec4(kNoSurface), noHit());
  uvec4 found = one_ray ? staticBefore(pixel) : uvec4(kNoSurface);
  known.is_found = known.is_known = isOneSurface(found);
  if (known.is_found && found.x != kSkySurface) {
    known.hit = Hit(instanceOf(found), found.y, found.z, vec2(0), 0.0, true);
    known.t = uintBitsToFloat(found.w);
  }
  if (known.is_found || frame.camera_rests == 0u) return known;
  known.consensus = known_hit_at(pixel);
  if (!isOneSurface(known.consensus)) return known;
  float t = kFar;
  bool is_sky = known.consensus.x == kSkySurface;
  if (!is_sky && (spares_rays || isMoving(known.consensus)))
    known.consensus_hit = hitOnConsensus(slice, ray, known.consensus, t);
  known.is_known = spares_rays && (is_sky || isHit(known.consensus_hit));
  if (known.is_known) known.hit = known.consensus_hit;
  if (isHit(known.hit)) known.t = t;
  return known;
}

// True if the hit of a fully traced sample is on another surface than the consensus predicts.
bool contradicts(Known known, Hit hit) {
  if (!isOneSurface(known.consensus)) return false;
  uvec4 ids = idsOf(hit);
  if (isMoving(known.consensus)) return isHit(known.consensus_hit) && idsOf(known.consensus_hit) != ids;
  if (!isOneTriangle(known.consensus)) ids.z = known.consensus.z;
  return isAtRest(hit) && known.consensus.xyz != ids.xyz;
}

// Shadows at the hit point that the first samples agree on (form of lib/consensus.glsl); 0 if unknown. With a static
// camera, the shadows are stored at the pixel itself. With a moving camera, they are stored at the pixel where the
// point is at the raster time.
// `is_shown`: output; true if, with a moving camera, the first samples agree on the point's triangle at that pixel. The
// raster image is then assumed to show the point.
uint shadowsAt(ivec2 pixel, Hit hit, out bool is_shown) {
  is_shown = false;
  if (!kFrozen || !isHit(hit)) return 0u;
  ivec2 place = pixel;
  bool camera_rests = frame.camera_rests != 0u;
  if (camera_rests && !isAtRest(hit)) return 0u;
  if (!camera_rests && !isInRaster(hit, place)) return 0u;
  uvec4 shown = known_hit_at(place);
  is_shown = !camera_rests && isOneTriangle(shown) && shown.xyz == idsOf(hit).xyz;
  return shadowsOf(known_shadows_at(place), hit.instance);
}

// Nearest hit on a sample's ray. If `is_known`, `static_background` is the known nearest hit on a static surface, at the
// distance `t`. Then only moving surfaces up to that hit are tested. If no moving surface can be visible, no ray is traced. At
// equal distance the first instance of the scene wins. On return, `t` is the distance of the returned hit along the ray.
Hit nearestHit(ivec2 pixel, uint slice, Ray ray, bool is_known, Hit static_background, inout float t) {
  if (is_known && (!isAtRest(static_background) || !isReachedAt(slice, pixel))) return static_background;
  uint mask = is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  float end = is_known && isHit(static_background) ? uintBitsToFloat(floatBitsToUint(t) + 1u) : kFar;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, end, NO_INSTANCE, NO_INSTANCE);
  if (is_known && (!isHit(hit) || (hit.t == t && hit.instance > static_background.instance))) return static_background;
  t = hit.t;
  // Intersect the ray again by the function of the raster layer, so that the result does not depend on the device and is equal
  // bit for bit for static surfaces.
  return isHit(hit) ? hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive) : hit;
}

// Sets the lights that `shade` takes as visible (bits x) and as blocked (bits y) without a shadow ray.
void setKnownLights(uvec2 lights) {
  known_visible = found_visible = lights.x;
  known_blocked = found_blocked = lights.y;
}

// Linear radiance of a hit, or of the sky. `known`: bits of the lights assumed to be visible (x) and blocked (y). With
// `spares_rays`, these lights get no shadow ray. Otherwise all shadow rays are traced, and a contradiction sets `is_mismatch`.
vec3 colorOf(uint slice, Ray ray, Hit hit, uvec2 known, bool spares_rays) {
  if (!isHit(hit)) return environment(ray.direction);
  setKnownLights(spares_rays ? known : uvec2(0u));
  vec3 color = shade(kFrozen ? SLICE_RASTER : slice, hit);
  is_mismatch = is_mismatch || ((known.x & found_blocked) | (known.y & found_visible)) != 0u;
  return color;
}

// Summary of the surfaces of several samples (form of lib/consensus.glsl): the summary `before` and one more surface, `ids`,
// joined.
uvec4 withSurface(uvec4 before, uvec4 ids) {
  if (before.x == kNoSurface) return ids;
  if (before.xy != ids.xy) return uvec4(kSeveralSurfaces, 0u, 0u, 0u);
  if (before.z != ids.z) before.z = kSeveralSurfaces;
  return before;
}

// Records a moving surface in the summary of the pixel, unless an earlier sample has hit a static surface.
void recordMoving(ivec2 pixel, Hit hit) {
  uvec4 before = imageLoad(static_background_img, pixel);
  if (before.x == kNoSurface || isMoving(before)) imageStore(static_background_img, pixel, withSurface(before, idsOf(hit)));
}

// Records a surface and its shadows for the consensus and for later samples. The surface is a static hit, or the hit of
// a probe, an extra ray at the raster time without shading. `background_t`: distance of the hit along its ray. Returns
// true if an earlier sample of the pixel has recorded such a surface.
bool recordSurface(ivec2 pixel, Hit hit, float background_t) {
  uvec4 before = imageLoad(static_background_img, pixel);
  bool is_first = before.x == kNoSurface || isMoving(before);
  if (is_first) before = uvec4(kNoSurface);
  imageStore(static_background_img, pixel, withSurface(before, uvec4(idsOf(hit).xyz, floatBitsToUint(background_t))));
#if PARAM_writes_stats
  if (isHit(hit)) {
    uint shadows = shadowsFrom(uvec2(found_visible, found_blocked));
    imageStore(shadows_img, pixel, withShadows(imageLoad(shadows_img, pixel), hit.instance, shadows));
  }
#endif
  return !is_first;
}

// Records a static hit: surface, shadows, mean radiance and contrast.
void recordStatic(ivec2 pixel, Hit hit, float background_t, vec3 color) {
  bool was_static = recordSurface(pixel, hit, background_t);
  vec4 static_mean = imageLoad(static_mean_img, pixel);
  imageStore(static_mean_img, pixel, withSample(static_mean, color));
#if PARAM_writes_stats
  vec3 change = abs(color - static_mean.rgb);
  float contrast = max(change.r, max(change.g, change.b)) / max(max(static_mean.r, max(static_mean.g, static_mean.b)), 1e-6);
  if (was_static) imageStore(contrast_img, pixel, vec4(max(contrast, imageLoad(contrast_img, pixel).x)));
#endif
}

// Bits of the lights that are visible (x) and blocked (y) at the hit, from the light visibility of the shadow tile. 0 if the
// raster image does not show the hit, because the tile's result is valid only for surfaces that the raster image shows. With
// pixel = centre, the pixel must show the hit's triangle. With pixel = box, the pixel and the eight pixels around must show the
// hit's surface.
uvec2 knownShadows(ivec2 pixel, Hit hit) {
  if (!isHit(hit)) return uvec2(0u);
  uvec3 ids = uvec3(hit.instance + 1u, hit.geometry, hit.primitive);
#if PARAM_pixel == pixel_box
  bool is_shown = true;
  ivec2 last = textureSize(hit_tex, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    is_shown = is_shown && hit_at(at).xy == ids.xy;
  }
#else
  bool is_shown = hit_at(pixel).xyz == ids;
#endif
  return is_shown ? light_visibility_at(pixel / params.shadow_tile).xy : uvec2(0u);
}

#if PARAM_probes
// Probe: traces a ray at the raster time through a position in the pixel, and records the surface hit and its shadows. The
// probe has no radiance: with a moving camera, it is on another ray than the sample.
void probe(ivec2 pixel, vec2 position_px) {
  Ray ray = cameraRay(SLICE_RASTER, position_px);
  float t = kFar;
  Hit hit = nearestHit(pixel, SLICE_RASTER, ray, false, noHit(), t);
  setKnownLights(knownShadows(pixel, hit));
  if (isHit(hit)) findShadows(SLICE_RASTER, hit);
  recordSurface(pixel, hit, t);
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
  bool validated = isValidated(pixel / kValidationBlock, params.validation_share);
  bool spares_rays = PARAM_every_ray == 0 && !validated;
  // With a static camera, all rays through the centre of a pixel are one ray.
  bool one_ray = PARAM_every_ray == 0 && kFrozen && PARAM_pixel == pixel_centre && frame.camera_rests != 0u;

  vec4 even = even_color_at(pixel);
  bool is_even = kFrozen && even.a != 0.0 && spares_rays && !one_ray && frame.camera_rests != 0u;

  Known known = knownOn(pixel, slice, ray, one_ray, spares_rays);
  float t = known.t;
  Hit hit = nearestHit(pixel, slice, ray, known.is_known, known.hit, t);
  bool at_rest = isAtRest(hit);
  is_mismatch = !spares_rays && contradicts(known, hit);

  // Test if the hit point is occluded at the raster time. The test costs one ray, so it runs in two cases only. First, the
  // report regions need the result. Second, the camera moves, and the first samples give the shadows of more than one light:
  // these shadows save more rays than the test costs, but they are valid only for a point that is visible at the raster time.
  // No test is needed if the raster image is assumed to show the point (`is_shown`).
  uint regions = 0u, wanted = 0u;
  bool is_static = false, is_shown;
#if PARAM_mark_regions
  regions = regionsBefore(pixel);
  is_static = PARAM_pixel == pixel_centre && kFrozen && cameraIsStill(slice) &&
             (at_rest || hasRasterPose(slice, hit.instance));
  if (!is_static) wanted = wantedRegions(pixel, hit, regions);
#endif
  uint shadows = shadowsAt(pixel, hit, is_shown);
  bool has_shadows = frame.camera_rests == 0u && countLights(shadows) > 1;
  bool tests_occlusion = !(is_shown && spares_rays) && (wanted != 0u || has_shadows);
  bool is_hidden = tests_occlusion && wasOccluded(pixel, hit);
  is_mismatch = is_mismatch || (is_shown && is_hidden);
  if (frame.camera_rests == 0u && (tests_occlusion ? is_hidden : !is_shown)) shadows = 0u;

  bool uses_tile_lights = kFrozen && frame.camera_rests != 0u && at_rest && shadows == 0u;
  vec3 color;
  if (known.is_found && at_rest) color = staticMeanBefore(pixel).rgb;
  else if (is_even && at_rest) color = even.rgb;
  else color = colorOf(slice, ray, hit, uses_tile_lights ? knownShadows(pixel, hit) : lightsOf(shadows), spares_rays);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  bool stats = frame.camera_rests != 0u && !known.is_known && (PARAM_writes_stats != 0 || one_ray);
  if (stats && at_rest) recordStatic(pixel, hit, t, color);
  else if (stats && PARAM_pixel == pixel_box) recordMoving(pixel, hit);
#if PARAM_static_once_per_loop
  if (isInMovingRect(pixel)) addSample(pixel, number, color);
  else setSamples(pixel, color);
#else
  addSample(pixel, number, color);
#endif

#if PARAM_mark_regions
  uint now = regions | regionsOf(pixel, slice, ray, hit, is_static, is_hidden ? wanted : 0u);
  if (now != regions) imageStore(regions_img, pixel, uvec4(now, 0u, 0u, 0u));
#endif
#if HAS_known_hit
  if (validated) count_validated(1u);
  if (validated && is_mismatch) count_mismatched(1u);
#endif
#if PARAM_probes
  if (kFrozen && frame.camera_rests == 0u) probe(pixel, vec2(pixel) + stratified2(index, number));
#endif
}
