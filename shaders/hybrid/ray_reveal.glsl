// SPDX-License-Identifier: MIT
// Surface behind the foreground, found by tracing the ray of the raster sample past the foreground (Tan, Cui, Bhojan 2020, "Ray
// Reveal").
// In:  `hit`: foreground: instance + 1 (0 for the sky), geometry, primitive.
//      `mask`: mask, above 1/2 where a ray is traced.
// Out: `color`: linear radiance, quantised; this and all other outputs are 0 where nothing is revealed.
//      `depth`: view depth, metres; +inf for the sky; quantised.
//      `id`: instance + 1, geometry + 1; 0 for the sky.
//      `velocity`: displacement, px over the exposure, quantised.
//      `valid`: 1 where a surface or the sky is revealed, otherwise 0.
//      `found`: revealed surface: instance + 1 (0 for the sky), geometry, primitive.
// Method: visit the hits along the ray until one is on another object. The parameter `advance` chooses the next hit:
//   - origin_kept: next hit on the same ray, more than 4 representable depths behind the last hit;
//   - restart: next hit on a new ray from the last hit, behind this hit by more than 1e-5 of its depth;
//   - instance_filter: as origin_kept, ignoring the foreground's instance (only its geometry with `termination` =
//     geometry; nothing with disoccluded).
//   The parameter `termination` chooses the hit that ends the search:
//   - instance: first hit on another instance; geometry: first hit on another geometry or instance;
//   - luminance: first hit with another luminance than the foreground; disoccluded: with another displacement;
//   - motion: first hit that does not move as if fixed to the foreground's instance.
//   After `max_layers` hits that do not end the search, the search gives up (counter `capped`; result: `on_cap`).
// Fails: a second surface behind the revealed one stays hidden. `luminance` stops inside an object with a differently
//   lit back, and passes through a background of equal luminance. The picture is then not linear in the light, unless
//   `luminance_of` chooses base colours. `instance` and `geometry` miss self-occlusion, and stop at other parts of an
//   object made of several instances; with `motion`, the ray passes these parts.
#include "mixin/advance.glsl"
#include "mixin/shade.glsl"
#include "mixin/quantised.glsl"

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

// 1 if the termination rule is `luminance` and compares radiances. The radiance of the last hit, computed for that comparison,
// is then the colour of the result and need not be shaded again.
#if PARAM_termination == termination_luminance && PARAM_luminance_of == luminance_of_radiance
#define COLOR_IS_FOUND 1
#else
#define COLOR_IS_FOUND 0
#endif

// First and last of the poses that `movesWith` uses to compare the motion of a hit with the motion of the foreground,
// both relative to the raster time. The poses are shutter open and shutter close. If displacements are extrapolated,
// the only pose is the previous frame.
#if PARAM_displacement == displacement_extrapolated
const uint kFirstPose = SLICE_PREVIOUS, kLastPose = SLICE_PREVIOUS;
#else
const uint kFirstPose = SLICE_SHUTTER_OPEN, kLastPose = SLICE_SHUTTER_CLOSE;
#endif

// True if the hit moves as if it were fixed to the foreground's instance: at each pose from kFirstPose to kLastPose, it is
// within `same_motion` px of the screen position that a fixed point would have. Such a surface (a load on a truck, a lamp in
// its shade) hides the same background as the foreground.
bool movesWith(Hit hit, uint instance) {
  if (hit.instance == instance) return true;
  vec3 raster_ws = positionOf(SLICE_RASTER, hit);
  for (uint slice = kFirstPose; slice <= kLastPose; ++slice) {
    vec2 own = pixelFromView(slice, viewFromWorld(slice, positionOf(slice, hit)));
    vec2 carried = pixelFromView(slice, viewFromWorld(slice, carriedBy(instance, slice, raster_ws)));
    if (!(distance(own, carried) <= params.same_motion)) return false;
  }
  return true;
}

// Next hit of the search behind the hit `last`, by the parameter `advance`. `front`: hit on the foreground.
Hit nextHit(Ray ray, Hit front, Hit last) {
#if PARAM_advance == advance_restart
  return nextFromHit(ray, last);
#elif PARAM_advance == advance_instance_filter && PARAM_termination == termination_geometry
  return nextAlong(ray, last, front.instance, front.geometry);
#elif PARAM_advance == advance_instance_filter && PARAM_termination != termination_disoccluded
  return nextAlong(ray, last, front.instance, NO_INSTANCE);
#else
  return nextAlong(ray, last, NO_INSTANCE, NO_INSTANCE);
#endif
}

// The hit, recomputed from its triangle. The ray is intersected with the triangle by the function that the raster layer uses,
// so that the result does not depend on the device that traced the ray.
Hit exactly(Ray ray, Hit hit) {
  return hitOnTriangle(SLICE_RASTER, ray, hit.instance, hit.geometry, hit.primitive);
}

vec3 pointOn(Ray ray, Hit hit) { return ray.origin + ray.direction * hit.t; }

// True if the displacements of the hit and the foreground at this pixel differ by more than `same_motion` px.
bool movesApart(Ray ray, Hit hit, Hit front) {
  Hit exact = exactly(ray, hit);
  return !(distance(displacementOf(exact, pointOn(ray, exact)), displacementOf(front, pointOn(ray, front))) <=
           params.same_motion);
}

// True if the hit belongs to another object than the foreground, by the parameter `termination`. Not used with `termination` =
// luminance, which firstBackground tests itself.
bool isOther(Ray ray, Hit hit, Hit front) {
#if PARAM_termination == termination_motion
  return !movesWith(hit, front.instance);
#elif PARAM_termination == termination_disoccluded
  return movesApart(ray, hit, front);
#elif PARAM_termination == termination_geometry
  return hit.instance != front.instance || hit.geometry != front.geometry;
#else
  return hit.instance != front.instance;
#endif
}

// Result of a search.
struct Found {
  Hit hit;
  vec3 color;   // `comparedColor` of the last hit; computed only with the termination rule `luminance`
  bool capped;  // true if the search gave up
  bool passed;  // true if the search, by the termination rule `luminance`, skipped a hit on another instance of like luminance
};

// Linear colour of a hit, by the parameter `luminance_of`. The termination rule `luminance` compares this colour with the
// colour of the foreground.
vec3 comparedColor(Hit hit) {
#if PARAM_luminance_of == luminance_of_base_color
  Surface surface = surfaceOf(SLICE_RASTER, hit);
  vec4 texel = texelsOf(surface, 1, footprintOf(SLICE_RASTER, surface)).base_color;
  return baseColorOf(scene_materials[surface.material], surface, texel);
#elif PARAM_luminance_of == luminance_of_material
  return scene_materials[geometryOf(hit.instance, hit.geometry).material].mean_color;
#else
  return shade(SLICE_RASTER, hit);
#endif
}

// First hit behind `front` on another object, or a miss. If the search gives up after `max_layers` hits, the result is the last
// of these hits. A search also gives up after 8 repeated hits on the same triangle: far from the origin, `advance` = restart
// may repeat a hit without end.
// With `termination` = luminance, the first iteration of the loop evaluates the foreground. The function then contains the
// shading code only once, which saves seconds of compile time. The term 1e-4 in the luminance test prevents a search behind a
// black foreground from ending at another black surface (docs/derivations.md).
Found firstBackground(Ray ray, Hit front) {
  Found found = Found(front, vec3(0), false, false);
  bool past_front = PARAM_termination != termination_luminance;
  float reference = 0.0;
  int layer = 0;
  uint met_again = 0u;
  while (layer < params.max_layers && met_again < 8u) {
    if (past_front) {
      Hit hit = nextHit(ray, front, found.hit);
      bool again = isSameTriangle(hit, found.hit);
      found.hit = hit;
      if (again) {
        ++met_again;
        continue;
      }
      if (!isHit(hit)) break;
    }
#if PARAM_termination == termination_luminance
    found.color = comparedColor(exactly(ray, found.hit));
    float here = luminance(found.color);
    if (!past_front) {
      reference = here;
      past_front = true;
      continue;
    }
    if (abs(here - reference) > params.tolerance * max(here, reference) + 1e-4) break;
    found.passed = found.passed || found.hit.instance != front.instance;
#else
    if (isOther(ray, found.hit, front)) break;
#endif
    ++layer;
  }
  found.capped = layer == params.max_layers || met_again == 8u;
  if (met_again > 0u) count_met_again(met_again);
  return found;
}

// Values of the pass's outputs at a pixel.
struct Revealed {
  vec4 color;
  float depth;
  uvec2 id;
  vec2 velocity;
  bool valid;
  uvec3 hit;
};

const Revealed kNothing = Revealed(vec4(0), 0.0, uvec2(0), vec2(0), false, uvec3(0));

Revealed surfaceHit(Ray ray, Found found) {
  Hit hit = exactly(ray, found.hit);
#if COLOR_IS_FOUND
  vec3 color = found.color;
#else
  vec3 color = shade(SLICE_RASTER, hit);
#endif
  return Revealed(vec4(color, 1), hit.t, uvec2(hit.instance, hit.geometry) + 1u,
                  displacementOf(hit, pointOn(ray, hit)), true, uvec3(hit.instance + 1u, hit.geometry, hit.primitive));
}

Revealed skyHit(Ray ray) {
  return Revealed(vec4(environment(ray.direction), 1), uintBitsToFloat(0x7f800000u), uvec2(0),
                  displacementOfSky(ray.direction), true, uvec3(0));
}

// Searches behind the foreground of a pixel, and counts the result.
Revealed revealedBackground(ivec2 pixel) {
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
  Hit front = hitOnTriangle(SLICE_RASTER, ray, ids.x - 1u, ids.y, ids.z);
  Found found = firstBackground(ray, front);
  if (found.capped) count_capped(1u);
  if (found.passed) count_passed(1u);
  if (found.capped && PARAM_on_cap == on_cap_fallback) return kNothing;
  count_revealed(1u);
  return isHit(found.hit) ? surfaceHit(ray, found) : skyHit(ray);
}

// True if the pixel is masked and shows a surface. Pixels of the sky need no ray, because nothing is behind the sky.
bool isMasked(ivec2 pixel) {
  return texelFetch(mask_tex, pixel, 0).r > 0.5 && texelFetch(hit_tex, pixel, 0).x != 0u;
}

void run(ivec2 pixel) {
  if (!isMasked(pixel)) return;  // outputs are cleared to 0
  Revealed revealed = revealedBackground(pixel);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(color_img, pixel, quantisedColor(revealed.color));
  imageStore(depth_img, pixel, vec4(quantisedDepth(revealed.depth)));
  imageStore(id_img, pixel, uvec4(revealed.id, 0u, 0u));
  imageStore(velocity_img, pixel, vec4(quantisedVelocity(revealed.velocity), 0, 0));
  imageStore(valid_img, pixel, vec4(revealed.valid ? 1.0 : 0.0));
  imageStore(found_img, pixel, uvec4(revealed.hit, 0u));
}
