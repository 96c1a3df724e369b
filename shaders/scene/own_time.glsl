// SPDX-License-Identifier: MIT
// Rays at their own time, for the samples of a pixel at which no layer has anything: the scene as it stands then, shaded
// as at the capture.
// In:  seen (linear, sum of the samples that layers explain over the number of all; alpha: their share), open (a bit for
//      each of the loop's times at which nothing does); hit, color, depth, id of what raster saw at the capture, and
//      revealed_color, revealed_depth, revealed_id, revealed_valid of what was revealed behind it.
// Out: picture (linear, alpha 1). In the share `audit` of blocks of pixels that motion may reach the other samples are
//      traced too; `wrong` counts pixels whose mean is otherwise by `wrong_by` of it.
// What a ray meets and a layer of the capture holds has that layer's colour (mixin/captured_color.glsl).
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

// The mean of what is seen at these times.
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
  if (isNarrow(all_seen, 0.0)) return all_seen.low;  // of equal colours not rounded
#endif
  return fromSum(sum / float(count));
}

// Counts where what the layers explain is wrong.
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
    // What is audited, then what is open: in one loop, since each copy of what is seen takes seconds to compile.
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
