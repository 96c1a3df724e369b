// SPDX-License-Identifier: MIT
// Per-time layered composite: for each time sample, the nearest surface of any layer that really is at the pixel then.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure), dominant (the same, per tile) of
//      what raster saw; second (per tile): another displacement found around; revealed_color, revealed_depth,
//      revealed_velocity, revealed_valid (> 1/2) of what lies behind; revealed_dominant: where that layer has its own.
// Out: blurred (linear, alpha 1).
// For t_i at the midpoints (i + 1/2 + jitter)/N of the exposure: each candidate displacement g says where a surface
//   that is at X at t_i would be now, Y = X - t_i*g. A texel Y of a layer is at X then if |Y + t_i*d(Y) - X| <=
//   max(3/4, |g|/(2N)) (3/4 px: the rounding of Y); one that is not leads to a second guess, by its own d. The nearest
//   texel that is there is what X shows at t_i; of equal depths the earlier candidate and the raster layer win. The
//   mean over i is the result: weights add up to 1 by construction, order in depth and correlation of movements come
//   out right.
// Candidates: the tile's displacements (dominant, second, revealed), those of X in both layers, and those met in both
//   layers at the taps X - t_i*d along d = dominant and second, and at X + t_i*d, as far as they differ by more than
//   half a pixel from all before; kMaxCandidates in all. Without the taps the slower of two moving surfaces is missed,
//   without those to the other side a slower one that moves against the dominant one, without `second` one that
//   crosses it.
// If no layer has anything at X at t_i, it is what was revealed at X, else what raster saw there (counter `fallback`).
// Fails: surfaces hidden at the capture and not revealed (second layer and beyond); motion that bends or magnifies by
//   more than the tolerance within the distance moved; more motions at one pixel than candidates.
#include "lib/blur.glsl"
#include "lib/jitter.glsl"
#include "lib/sanitise.glsl"

const int kMaxCandidates = 4;

// Rays and raster find one surface at depths that differ by rounding: nearer by less than this share is equal.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

struct Candidates {
  vec2 d[kMaxCandidates];
  int count;
};

struct Best {
  vec3 color;
  float depth;
  bool found;
};

vec2 limited(vec4 texel) { return clampLength(finiteDisplacement(texel), params.limit * float(frame.size.x)); }

bool isRevealed(ivec2 pixel) { return texelFetch(revealed_valid_tex, pixel, 0).x > 0.5; }

Candidates withCandidate(Candidates candidates, vec2 d) {
  for (int i = 0; i < candidates.count; ++i) {
    if (lengthOf(candidates.d[i] - d) <= 0.5) return candidates;
  }
  if (candidates.count == kMaxCandidates) return candidates;
  candidates.d[candidates.count] = d;
  candidates.count += 1;
  return candidates;
}

Candidates withBothLayers(Candidates candidates, ivec2 at) {
  candidates = withCandidate(candidates, limited(texelFetch(velocity_tex, at, 0)));
  if (isRevealed(at)) candidates = withCandidate(candidates, limited(texelFetch(revealed_velocity_tex, at, 0)));
  return candidates;
}

Candidates harvested(Candidates candidates, ivec2 pixel, vec2 d, float jitter) {
  ivec2 size = textureSize(color_tex, 0);
  bool one_sided = !isCentred(frame.shutter);  // else the taps lie to both sides already
  for (int i = 0; i < params.samples && candidates.count < kMaxCandidates; ++i) {
    ivec2 offset = roundSymmetric(tapOffset(d, sampleTime(i, params.samples, jitter, frame.shutter)));
    if (isInside(pixel + offset, size)) candidates = withBothLayers(candidates, pixel + offset);
    if (one_sided && isInside(pixel - offset, size)) candidates = withBothLayers(candidates, pixel - offset);
  }
  return candidates;
}

bool isAt(ivec2 pixel, ivec2 now, vec2 d, float t, float tolerance_px) {
  return lengthOf(vec2(now - pixel) + t * d) <= tolerance_px;
}

// Where, of a guess, what the texel there says instead: motion that varies over a surface (perspective, turning) is met
// by asking once more from where the first guess led. A texel that passes `isAt` is at the pixel, however it was found.
ivec2 asked(ivec2 pixel, vec2 d, float t) { return pixel + roundSymmetric(tapOffset(d, t)); }

Best nearerRaster(Best best, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  vec2 d = limited(texelFetch(velocity_tex, now, 0));
  if (!isAt(pixel, now, d, t, tolerance_px)) {
    now = asked(pixel, d, t);
    if (!isInside(now, textureSize(color_tex, 0))) return best;
    if (!isAt(pixel, now, limited(texelFetch(velocity_tex, now, 0)), t, tolerance_px)) return best;
  }
  float depth = saneDepth(texelFetch(depth_tex, now, 0).x);
  if (best.found && depth >= best.depth * kSameDepth) return best;
  return Best(finiteColor(texelFetch(color_tex, now, 0)), depth, true);
}

Best nearerRevealed(Best best, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  if (!isRevealed(now)) return best;
  vec2 d = limited(texelFetch(revealed_velocity_tex, now, 0));
  if (!isAt(pixel, now, d, t, tolerance_px)) {
    now = asked(pixel, d, t);
    if (!isInside(now, textureSize(color_tex, 0)) || !isRevealed(now)) return best;
    if (!isAt(pixel, now, limited(texelFetch(revealed_velocity_tex, now, 0)), t, tolerance_px)) return best;
  }
  float depth = saneDepth(texelFetch(revealed_depth_tex, now, 0).x);
  if (best.found && depth >= best.depth * kSameDepth) return best;
  return Best(finiteColor(texelFetch(revealed_color_tex, now, 0)), depth, true);
}

Best seenAt(ivec2 pixel, Candidates candidates, float t) {
  Best best = Best(vec3(0), 0.0, false);
  for (int k = 0; k < candidates.count; ++k) {
    ivec2 now = pixel + roundSymmetric(tapOffset(candidates.d[k], t));
    if (!isInside(now, textureSize(color_tex, 0))) continue;
    float tolerance_px = max(0.75, lengthOf(candidates.d[k]) / float(2 * params.samples));
    best = nearerRaster(best, pixel, now, t, tolerance_px);
    best = nearerRevealed(best, pixel, now, t, tolerance_px);
  }
  return best;
}

void run(ivec2 pixel) {
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  vec2 d_second = d, d_revealed = d;
#if HAS_second
  d_second = vec2(texelFetch(second_tex, pixel / params.tile, 0));
#endif
#if HAS_revealed_dominant
  d_revealed = vec2(texelFetch(revealed_dominant_tex, pixel / params.tile, 0));
#endif
  float fastest = max(lengthOf(d), lengthOf(d_revealed));
  if (reachFactor(frame.shutter) * fastest <= kStillRadius) {
    imageStore(blurred_img, pixel, vec4(vec3(texelFetch(color_tex, pixel, 0)), 1));
    return;
  }

  float jitter = jitterOf(pixel);
  Candidates candidates;
  candidates.count = 0;
  candidates = withCandidate(candidates, d);
  candidates = withCandidate(candidates, d_second);
  candidates = withCandidate(candidates, d_revealed);
  candidates = withBothLayers(candidates, pixel);
#if PARAM_harvest
  candidates = harvested(candidates, pixel, d, jitter);
  if (lengthOf(d_second - d) > 0.5) candidates = harvested(candidates, pixel, d_second, jitter);
#endif

  vec3 sum = vec3(0);
  uint fallbacks = 0u;
  for (int i = 0; i < params.samples; ++i) {
    Best best = seenAt(pixel, candidates, sampleTime(i, params.samples, jitter, frame.shutter));
    if (best.found) {
      sum += best.color;
      continue;
    }
    fallbacks += 1u;
    sum += isRevealed(pixel) ? finiteColor(texelFetch(revealed_color_tex, pixel, 0))
                             : finiteColor(texelFetch(color_tex, pixel, 0));
  }
  if (fallbacks > 0u) count_fallback(fallbacks);
  imageStore(blurred_img, pixel, vec4(sum / float(params.samples), 1));
}
