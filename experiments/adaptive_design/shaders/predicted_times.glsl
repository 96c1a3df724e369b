// SPDX-License-Identifier: MIT
// Blur by prediction, as in layered/in_gather.glsl, with rays for the time samples without a predicted surface.
// In:  the images of layered/in_gather.glsl
//      `hit`: raster layer: instance + 1 (0 = sky), geometry, primitive
// Out: `blurred`: linear radiance, alpha 1
// Method: predict the surface at each time sample by the functions of layered/in_gather.glsl. A surface is found in two
//   cases. Either a foreground covers the background of the pixel fully. Or the texel that is found by following the motion of
//   the background shows the background, and its own motion brings it to the pixel at that time. All other samples get a ray
//   at their time.
//   Validation: also trace `validation_rays` of the samples with a predicted surface. If one differs by more than
//   `mismatch` from the prediction, all samples of the pixel get rays. A hit takes the colour of a layer that shows it,
//   otherwise it is shaded.
// Fails: between the validation rays, a sample is wrong if a third surface is in front or if the path is not a straight line.
#define run gatherBothLayers
#include "layered/in_gather.glsl"
#undef run
#include "lib/moving_rect.glsl"
#include "mixin/raster_color.glsl"
#include "mixin/static_background.glsl"

// True if the raster layer shows the point of the background `back` that is at the pixel at time t. `color`: linear
// radiance of this point.
bool isBackgroundShown(ivec2 pixel, float t, Tap back, out vec3 color) {
  ivec2 now = tapFor(pixel, back.path, t);
  color = vec3(0);
  if (!isInside(now, ivec2(frame.size))) return false;
  Tap tap = rasterAt(now, t > 0.0);
  color = tap.color;
  return tap.instance == back.instance && isAt(pixel, now, tap.path, t, 0.75);
}

// True if the prediction finds the surface of time sample i of the pixel. `color`: predicted linear radiance.
bool isResolved(ivec2 pixel, int i, out vec3 color) {
  float t = sampleTime(i, params.samples, 0.0);
  Tap back = backgroundOf(pixel, t > 0.0);
  Path dominant = dominantOf(pixel, t > 0.0), own = pathOf(kRaster, pixel, t > 0.0);
  Cover cover = nearer(coverAt(pixel, dominant, tapFor(pixel, dominant, t), t, back),
                       coverAt(pixel, own, tapFor(pixel, own, t), t, back));
  vec3 behind = vec3(0);
  bool is_resolved = cover.share == 1.0 || isBackgroundShown(pixel, t, back, behind);
  color = mix(behind, cover.color, cover.share);
  return is_resolved;
}

// Linear radiance of time sample i of the pixel, by a ray. The ray updates `static_background`, which later rays reuse.
vec3 traced(ivec2 pixel, int i, inout StaticBackground static_background) {
  count_samples(1u);
  uint slice = SLICE_SAMPLE + uint(i);
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = nearestAt(slice, ray, static_background);
  if (isStaticBackground(hit) && static_background.is_known) return static_background.color;
  vec3 color = isHit(hit) ? rasterColorOf(hit) : environment(ray.direction);
  if (isStaticBackground(hit)) static_background = staticBackgroundOf(hit, color);
  return color;
}

void run(ivec2 pixel) {
  vec3 color = vec3(color_at(pixel));
  if (frame.exposure > 0.0 && isInMovingRect(pixel)) {
    StaticBackground static_background = staticBackgroundAt(pixel);
    bool is_refuted = false;
    for (int k = 0; k < params.validation_rays && !is_refuted; ++k) {
      int i = k * (params.samples - 1) / max(params.validation_rays - 1, 1);
      if (!isResolved(pixel, i, color)) continue;
      vec3 by = abs(color - traced(pixel, i, static_background));
      is_refuted = max(by.r, max(by.g, by.b)) > params.mismatch;
    }
    vec3 sum = vec3(0);
    for (int i = 0; i < params.samples; ++i) {
      if (is_refuted || !isResolved(pixel, i, color)) color = traced(pixel, i, static_background);
      sum += toSum(color);
    }
    color = fromSum(sum / float(params.samples));
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(blurred_img, pixel, vec4(color, 1));
}
