// SPDX-License-Identifier: MIT
// Traces the time samples that no layer resolves, each at the time of the sample.
// In:  `seen`:           linear: sum of the resolved samples, divided by the number of all; alpha: share of resolved samples
//      `open`:           bit i is set if time i of the loop is unresolved
//      `hit`:            raster layer: instance + 1 (0 = sky), geometry, primitive
//      `color`, `revealed_color`: linear radiance of the raster layer and of the revealed layer
//      `depth`, `revealed_depth`: view depth of both layers, m; +inf for the sky
//      `id`, `revealed_id`: instance + 1, geometry + 1 of both layers; 0 for the sky
//      `revealed_valid`: above 1/2 where the revealed layer has a surface
// Out: `picture`:        linear radiance, alpha 1
// Method: trace the scene as posed at the sample's time. If a layer shows the hit point, take that layer's colour
//      (mixin/captured_color.glsl); otherwise shade the point as at the raster time. The mean over the unresolved samples fills
//      their share. In the share `audit` of the pixel blocks in the moving rectangle, the resolved samples are traced too: the
//      counter `wrong` counts pixels whose mean differs by more than the share `wrong_by`.
// Fails: highlights and shadows do not move within the exposure. Silhouettes are aliased: the ray goes through the centre of
//      the pixel.
#include "lib/audit.glsl"
#include "lib/parts.glsl"
#include "lib/reached.glsl"
#include "mixin/captured_color.glsl"
#include "mixin/ground.glsl"

vec3 seenAt(ivec2 pixel, uint slice, inout Ground ground) {
  Ray ray = cameraRay(slice, samplePosition(pixel));
  Hit hit = nearestAt(slice, ray, ground);
  if (isGround(hit) && ground.is_known) return ground.color;
  vec3 color = isHit(hit) ? capturedColorOf(hit) : environment(ray.direction);
  if (isGround(hit)) ground = groundOf(hit, color);
  return color;
}

// Mean radiance over these times.
vec3 meanOf(ivec2 pixel, uvec2 times, inout Ground ground) {
  int count = countParts(times);
  vec3 sum = vec3(0);
  Spread all_seen = noSpread();
  while (hasParts(times)) {
    int number = firstPart(times);
    times &= ~partBit(number);
    vec3 color = seenAt(pixel, SLICE_SAMPLE + uint(number), ground);
    sum += toSum(color);
    all_seen = withColor(all_seen, color);
  }
#if PARAM_shades_unlike
  if (isNarrow(all_seen, 0.0)) return all_seen.low;  // equal colours: exact
#endif
  return fromSum(sum / float(count));
}

// Compares the mean of the resolved samples with traced ones. 1e-3 (linear radiance) keeps black pixels from mismatching.
void audit(vec4 seen, vec3 is_so) {
  vec3 said = vec3(seen) / seen.a;
  vec3 apart = abs(said - is_so), larger = max(abs(said), abs(is_so));
  float most = max(apart.r, max(apart.g, apart.b)), of = max(larger.r, max(larger.g, larger.b));
  count_audited(1u);
  if (most > params.wrong_by * of + 1e-3) count_wrong(1u);
}

void run(ivec2 pixel) {
  vec4 seen = texelFetch(seen_tex, pixel, 0);
  uvec2 all_times = allParts(int(frame.slice_count));
  uvec2 open = texelFetch(open_tex, pixel, 0).xy & all_times;
  bool audited = seen.a > 0.0 && open != all_times && isReached(pixel) && isAudited(pixel / kAuditBlock, params.audit);
  if (hasParts(open) || audited) {
    Ground ground = groundAt(pixel);
    // Round 0 audits the resolved samples, round 1 traces the unresolved ones. One loop: each copy of `seenAt` takes seconds to
    // compile.
    for (int round = audited ? 0 : 1; round < (hasParts(open) ? 2 : 1); ++round) {
      bool is_open = round == 1;
      vec3 mean = meanOf(pixel, is_open ? open : all_times & ~open, ground);
      if (!is_open) audit(seen, mean);
      if (is_open) count_samples(uint(countParts(open)));
      if (is_open) seen.rgb += (1.0 - seen.a) * mean;
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(picture_img, pixel, vec4(seen.rgb, 1));
}
