// SPDX-License-Identifier: MIT
// Distributed ray tracing in time (Cook, Porter, Carpenter 1984): each pixel draws one of the iteration's scene times,
// traces the scene as it truly stands then, and adds the colour. Nothing is clamped, and no displacement is used.
// Regions, with f the instance seen at the capture:
//   inner   some sample sees a farther, different instance than f;
//   outer   some sample sees a nearer, different instance than f;
//   hidden  some sample sees a point that was occluded at the capture.
#include "lib/mean.glsl"
#include "lib/random.glsl"
#include "lib/regions.glsl"
#include "mixin/shade.glsl"

const float kFar = 3.0e38;

bool sameTransform(SceneTransform a, SceneTransform b) {
  return a.row_x == b.row_x && a.row_y == b.row_y && a.row_z == b.row_z;
}

bool cameraIsStill(uint slice) {
  SceneCamera a = scene_cameras[slice], b = scene_cameras[SLICE_CAPTURE];
  return a.position == b.position && a.right == b.right && a.up == b.up && a.forward == b.forward &&
         a.half_extent == b.half_extent;
}

// Was the point hidden from the capture's camera? The last 2^-12 of the way is the point's own surface.
bool wasOccluded(vec3 position_ws) {
  SceneCamera camera = scene_cameras[SLICE_CAPTURE];
  vec3 position_vs = viewFromWorld(SLICE_CAPTURE, position_ws);
  if (position_vs.z <= camera.near) return true;
  Ray ray = cameraRay(SLICE_CAPTURE, pixelFromView(SLICE_CAPTURE, position_vs));
  return isHidden(SLICE_CAPTURE, ray, camera.near, position_vs.z * (1.0 - 1.0 / 4096.0));
}

// `is_still`: nothing about the sample has moved, so the capture's own ray tells what was hidden behind what.
uint regionsOf(ivec2 pixel, Hit hit, vec3 capture_ws, bool is_still, uint known) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  uint id = isHit(hit) ? hit.instance + 1u : 0u;
  uint found = 0u;
  bool farther = false;
  if (id != seen.x) {
    float before = kFar;
    if (seen.x != 0u)
      before = hitOnTriangle(SLICE_CAPTURE, cameraRay(SLICE_CAPTURE, samplePosition(pixel)), seen.x - 1u, seen.y, seen.z).t;
    float now = isHit(hit) ? hit.t : kFar;
    farther = now > before;
    if (farther) found |= kRegionInner;
    if (now < before) found |= kRegionOuter;
  }
  if (is_still) return known | found | (farther && isHit(hit) ? kRegionHidden : 0u);
  if (isHit(hit) && (known & kRegionHidden) == 0u && wasOccluded(capture_ws)) found |= kRegionHidden;
  return known | found;
}

// Means of even and odd iterations are kept apart: their difference tells how far off the mean of both can be.
void addSample(ivec2 pixel, vec3 color) {
  if ((frame.iteration & 1u) == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}

// All samples of the loop at once: where nothing that moves can be seen, every sample is the first one.
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

void run(ivec2 pixel) {
  uint index = uint(pixel.y) * frame.size.x + uint(pixel.x);
  uint number = frame.iteration + uint(params.taken);
  if (!takesPart(pixel)) {
    imageStore(sample_id_img, pixel, uvec4(0u));
    imageStore(sample_position_img, pixel, vec4(0));
    return;
  }
  vec4 still = imageLoad(still_img, pixel);
  bool caches = PARAM_shading == shading_frozen && PARAM_pixel == pixel_centre;
  uint slice = TIME_SLICE;
  if (frame.slice_count > 1u) slice += randomUint(index, number, 0u) % frame.slice_count;
  vec2 position_px = samplePosition(pixel);
#if PARAM_pixel == pixel_box
  position_px = vec2(pixel) + stratified2(index, number);
#endif
  Ray ray = cameraRay(slice, position_px);
  Hit hit = traceNearest(slice, ray, scene_cameras[slice].near, kFar);
  // As raster computes it, which does not depend on the device: what stands still is as the capture sees it, bit for bit.
  if (isHit(hit)) hit = hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  vec3 capture_ws = vec3(0);
  vec3 color;

  // What stands as at the capture, before a camera that does, has one colour: it is shaded once. Something that moves
  // may stand so at one time and uncover what is at rest at another, so the colour is known by whose it is.
  bool is_still = caches && cameraIsStill(slice) &&
                  (!isHit(hit) || sameTransform(transformOf(slice, hit.instance), transformOf(SLICE_CAPTURE, hit.instance)));
  float whose = isHit(hit) ? float(hit.instance) + 2.0 : 1.0;
  bool told_apart = whose < 16777216.0;  // representable
  if (isHit(hit)) capture_ws = positionOf(SLICE_CAPTURE, hit);
  if (is_still && told_apart && still.a == whose) {
    color = still.rgb;
  } else {
    color = isHit(hit) ? shade(PARAM_shading == shading_frozen ? SLICE_CAPTURE : slice, hit) : environment(ray.direction);
    if (is_still && told_apart) imageStore(still_img, pixel, vec4(color, whose));
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
#if PARAM_once_where_still
  bool reached = all(greaterThanEqual(pixel, frame.reach.xy)) && all(lessThan(pixel, frame.reach.zw));
  if (reached) addSample(pixel, color);
  else setSamples(pixel, color);
#else
  addSample(pixel, color);
#endif

#if PARAM_mark_regions
  uint known = imageLoad(regions_img, pixel).r;
  uint regions = regionsOf(pixel, hit, capture_ws, is_still, known);
  if (regions != known) imageStore(regions_img, pixel, uvec4(regions, 0u, 0u, 0u));
#endif
  imageStore(sample_id_img, pixel, isHit(hit) ? uvec4(hit.instance + 1u, hit.geometry + 1u, 0u, 0u) : uvec4(0u));
  imageStore(sample_position_img, pixel, isHit(hit) ? vec4(capture_ws, 1) : vec4(0));
}
