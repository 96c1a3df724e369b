// SPDX-License-Identifier: MIT
// Traces rays for the time samples that no layer resolves, each at the time of its sample.
// In:  `partial`: sum of the resolved samples, divided by the number of all samples, linear radiance; alpha: share of resolved
//        samples
//      `unresolved`: bit i is set if time i of the loop is unresolved
//      `hit`: raster layer: instance + 1 (0 = sky), geometry, primitive
//      `color`, `revealed_color`: linear radiance of the raster layer and of the revealed layer
//      `depth`, `revealed_depth`: view depth of both layers, metres; +inf for the sky
//      `id`, `revealed_id`: instance + 1, geometry + 1 of both layers; 0 for the sky
//      `revealed_valid`: above 1/2 where the revealed layer has a surface
// Out: `picture`: linear radiance, alpha 1
// Method: trace the scene as posed at the sample's time. If a layer shows the hit point, take that layer's colour
//   (mixin/raster_color.glsl). Otherwise shade the point as at the raster time. Add the mean of the traced samples to
//   `partial`, with the weight of the unresolved samples.
//   Validation: in the share `validation_share` of the pixel blocks in the moving rectangle, trace the resolved samples too.
//   The counter `mismatched` counts pixels where the mean of these rays differs from the mean of the layers by more than the
//   share `mismatch_tolerance`.
// Fails: highlights and shadows do not move within the exposure. Silhouettes are aliased, because each ray goes through the
//   centre of the pixel.
#include "lib/validation.glsl"
#include "lib/parts.glsl"
#include "lib/moving_rect.glsl"
#include "mixin/raster_color.glsl"
#include "mixin/static_background.glsl"

// Radiance at the pixel at the time of `slice`. The ray updates `static_background`, which later rays of the pixel reuse.
vec3 sampleAt(ivec2 pixel, uint slice, inout StaticBackground static_background) {
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = nearestAt(slice, ray, static_background);
  if (isStaticBackground(hit) && static_background.is_known) return static_background.color;
  vec3 color = isHit(hit) ? rasterColorOf(hit) : environment(ray.direction);
  if (isStaticBackground(hit)) static_background = staticBackgroundOf(hit, color);
  return color;
}

// Mean radiance at the pixel over the times of the loop in the set `times` (lib/parts.glsl).
vec3 meanOf(ivec2 pixel, uvec2 times, inout StaticBackground static_background) {
  int count = countParts(times);
  vec3 sum = vec3(0);
  ColorRange all_hit = emptyColorRange();
  while (hasParts(times)) {
    int number = firstPart(times);
    times &= ~partBit(number);
    vec3 color = sampleAt(pixel, SLICE_SAMPLE + uint(number), static_background);
    sum += toSum(color);
    all_hit = withColor(all_hit, color);
  }
#if PARAM_shades_contrast
  if (isNarrow(all_hit, 0.0)) return all_hit.low;  // the mean of equal colours is exact, without rounding
#endif
  return fromSum(sum / float(count));
}

// Compares the mean of a pixel's resolved samples (from `partial`) with the mean `is_so` of rays at the same times, and counts
// a mismatch. The tolerance has the constant part 1e-3 (linear radiance), so that nearly black pixels do not mismatch.
void validation_share(vec4 partial, vec3 is_so) {
  vec3 said = vec3(partial) / partial.a;
  vec3 apart = abs(said - is_so), larger = max(abs(said), abs(is_so));
  float most = max(apart.r, max(apart.g, apart.b)), of = max(larger.r, max(larger.g, larger.b));
  count_validated(1u);
  if (most > params.mismatch_tolerance * of + 1e-3) count_mismatched(1u);
}

void run(ivec2 pixel) {
  vec4 partial = texelFetch(partial_tex, pixel, 0);
  uvec2 all_times = allParts(int(frame.slice_count));
  uvec2 unresolved = texelFetch(unresolved_tex, pixel, 0).xy & all_times;
  bool validated = partial.a > 0.0 && unresolved != all_times && isInMovingRect(pixel) &&
                   isValidated(pixel / kValidationBlock, params.validation_share);
  if (hasParts(unresolved) || validated) {
    StaticBackground static_background = staticBackgroundAt(pixel);
    // Round 0 validates the resolved samples, round 1 traces the unresolved samples. One loop serves both, because each inlined
    // copy of `sampleAt` takes seconds to compile.
    for (int round = validated ? 0 : 1; round < (hasParts(unresolved) ? 2 : 1); ++round) {
      bool is_unresolved = round == 1;
      vec3 mean = meanOf(pixel, is_unresolved ? unresolved : all_times & ~unresolved, static_background);
      if (!is_unresolved) validation_share(partial, mean);
      if (is_unresolved) count_samples(uint(countParts(unresolved)));
      if (is_unresolved) partial.rgb += (1.0 - partial.a) * mean;
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(picture_img, pixel, vec4(partial.rgb, 1));
}
