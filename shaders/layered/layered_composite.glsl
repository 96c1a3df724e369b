// SPDX-License-Identifier: MIT
// Per-time layered composite: the mean over the time samples of the nearest surface of both layers that is at the pixel at each
// time (an extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Per-time layered gather").
// In:  color, depth: raster layer, linear; view depth, metres, +inf for the sky.
//      velocity, dominant, second: displacement d per pixel; per tile, the longest and another one; px over the exposure.
//      revealed_color, _depth, _velocity, _dominant: the same images of the revealed layer; _valid: > 1/2 if present.
//      velocity_post, dominant_post, second_post, revealed_*_post: displacements after the raster time (absent: as before it).
//      curve, revealed_curve, dominant_curve, dominant_place: deviation of paths from lines, px; texel of dominant (optional).
//      moved, background: per cell, > 1/2 where a moving (a revealed) surface is at some time (absent: everywhere).
//      unlisted: per cell, > 1/2 where a surface may arrive that the displacements of the tile do not lead to.
//      unreliable: per cell, bit i is set if the layers are unreliable at stratum i of at most 32.
//      silhouettes: > 1/2 next to a texel with a different displacement.
// Out: blurred: linear, alpha 1; with `marks_unresolved` the sum of the resolved samples over N, alpha: their share. Equals
//        color in cells without motion.
//      unresolved: bit i is set if stratum i of at most 64 is unresolved.
//      fallback_estimate: with WRITES_ESTIMATE, a fallback estimate of the unresolved samples, over N; alpha: its expected error (see
//        Guess).
// Method: at each midpoint t_i = (i + 1/2 + jitter)/N of the exposure, each candidate displacement g leads to the texel
//   Y = X - t_i*g of both layers. Y is at X if |Y + t_i*d(Y) - X| <= max(3/4, .99 min(|g|, |d(Y)|)/(2N)) px (see Constants). If
//   not, d(Y) leads to one more texel, on curves to three. The nearest texel at X counts, at equal depths the first one found.
//   Candidates: the displacements of the tile; d of both layers at X and, with `search_taps`, at X +- t_i*g for g = dominant
//   and second, nearest first. At most 4 that differ by more than 1/2 px, others after the raster time in a split exposure.
//   No surface: the texel of X, revealed or raster (counter `fallback`). With `marks_unresolved` the sample is unresolved, as
//   are unreliable samples, samples beside a silhouette, and pixels with too many candidates; with `marks_contrast` also
//   samples between texels with a contrast above `contrast`, of surfaces that move by less than `detail_below` px per sample.
// Fails: surfaces hidden at the raster time and not revealed (a second layer); paths that deviate, or surfaces that grow, by
//   more than the tolerance; more than 4 different motions at a pixel.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/candidates.glsl"
#include "lib/parts.glsl"
#include "lib/color_range.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

// --- Constants
// ----------------------------------------------------------------------------------------------------------------
// 3/4 px (mixin/candidates.glsl): rounding a position to a texel moves it by at most sqrt(1/2) = .71 px.
// .99 min(|g|, |d(Y)|)/(2N) (mixin/candidates.glsl): two time samples are |d|/N px apart. A texel half-way is as near to the
//   one as to the other and must count at neither, so the tolerance is just below half. The tolerance |g|/(2N) counted the
//   pixel's own foreground at the samples next to the raster time. With up to four samples and motion above 10 px the error
//   was then up to twice the error of ground truth with as many samples; now at most 1.05 times (237c3545, RenderPassage).
// 1/4 px^2 (mixin/candidates.glsl): candidates within 1/2 px lead to texels at most 1/2 px apart, since |t| <= 1.
// 4 px^2, .02 |d|^2 (mixin/candidates.glsl): a fifth candidate is one too many if it differs from each of the four by more than
//   2 px and by more than sqrt(.02) = .14 of its length, as in shaders/cell/classify_cells.glsl. No derivation is recorded.
// 1.5 px (isUnsure, colorFound): a sample lies at most sqrt(2) = 1.41 px from the texels of its bilinear footprint. The rest
//   allows for displacements that vary over a surface.

// True if unresolved samples get a fallback estimate: the layers are then searched at these samples too.
#ifdef WRITES_ESTIMATE
const bool kWritesEstimate = true;
#else
const bool kWritesEstimate = false;
#endif

// Depths that differ by less than 2^-16 of the depth count as equal: rays and raster find one surface at depths that differ by
// rounding. 2^-16 is 128 to 256 units in the last place of a float.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// A sample within this distance of a texel's centre along an axis, px, reads no texel beside it. 1e-3: the texels beside then
// have weights below 1e-3, which colorFound skips. 0.05: no derivation is recorded.
const float kCentre = PARAM_marks_contrast != 0 ? 1e-3 : 0.05;

struct Nearest {
  int layer;
  ivec2 now;  // texel of its layer, at the raster time
  float depth;
  bool at_silhouette;  // a moving silhouette may pass between the texels around it
};

// --- Surfaces at a pixel
// ----------------------------------------------------------------------------------------------------------------

Nearest nearer(Nearest nearest, int layer, ivec2 now, float depth) {
  if (nearest.layer != kNothing && depth >= nearest.depth * kSameDepth) return nearest;
  return Nearest(layer, now, depth, nearest.at_silhouette);
}

// Raster surface at the pixel itself, where most searches end. Read once.
struct Own {
  Path before, after;
  float depth;
  vec3 color;
};

Own ownOf(ivec2 pixel) {
  float depth = saneDepth(depth_at(pixel).x);
  return Own(pathOf(kRaster, pixel, false), pathOf(kRaster, pixel, true), depth, colorOf(kRaster, pixel));
}

Path rasterPath(Own own, ivec2 pixel, ivec2 now, bool after) {
  if (now != pixel) return pathOf(kRaster, now, after);
  if (after) return own.after;
  return own.before;
}

float rasterDepth(Own own, ivec2 pixel, ivec2 now) {
  return now == pixel ? own.depth : saneDepth(depth_at(now).x);
}

Nearest nearerRaster(Nearest nearest, Own own, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurveIterations; ++i) {
    Path path = rasterPath(own, pixel, now, after);
    if (isThere(pixel, now, path, t, tolerance_px))
      return nearer(nearest, kRaster, now, rasterDepth(own, pixel, now));
    if (!iteratesAgain(i, path)) break;
    ivec2 next = nextTexelOf(kRaster, pixel, now, path, t);
    if (next == now || !isInside(next, textureSize(color_tex, 0))) break;
    now = next;
  }
  return nearest;
}

Nearest nearerRevealed(Nearest nearest, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurveIterations && isRevealed(now); ++i) {
    Path path = pathOf(kRevealed, now, after);
    if (isThere(pixel, now, path, t, tolerance_px)) return nearer(nearest, kRevealed, now, revealedDepth(now));
    if (!iteratesAgain(i, path)) break;
    ivec2 next = nextTexelOf(kRevealed, pixel, now, path, t);
    if (next == now || !isInside(next, textureSize(color_tex, 0))) break;
    now = next;
  }
  return nearest;
}

// True if a moving silhouette may pass between the texels around a sample. With marks_contrast: if their displacements differ
// (movesOtherwise). Otherwise: if some of these texels are at the pixel at time t, within 1.5 px, and some are not.
bool isAtSilhouette(ivec2 pixel, ivec2 now, vec2 offset, float t) {
  vec2 off_centre = offset - vec2(now - pixel);
  ivec2 beside = ivec2(greaterThan(off_centre, vec2(kCentre))) - ivec2(lessThan(off_centre, vec2(-kCentre)));
  if (beside == ivec2(0) || silhouettes_at(now).x < 0.5) return false;
  ivec2 size = textureSize(color_tex, 0);
#if PARAM_marks_contrast
  vec2 d = pathOf(kRaster, now, t > 0.0).d;
  bool otherwise = false;
  for (int k = 1; k < 4; ++k) {
    ivec2 at = clampToImage(now + ivec2(k & 1, k >> 1) * beside, size);
    otherwise = otherwise || movesOtherwise(pathOf(kRaster, at, t > 0.0).d, d, params.slowest);
  }
  return otherwise;
#else
  int there = 0;
  for (int k = 0; k < 4; ++k) {
    ivec2 at = clampToImage(now + ivec2(k & 1, k >> 1) * beside, size);
    there += isAt(pixel, at, pathOf(kRaster, at, t > 0.0), t, 1.5) ? 1 : 0;
  }
  return there % 4 != 0;
#endif
}

// First texel of the search along a candidate. On a curve: the texel that has this curve, because Newton's method reaches
// farther from there. Otherwise: `now`, the tap of the candidate.
ivec2 startAt(int layer, Candidates candidates, int k, ivec2 now) {
#if HAS_curve
  ivec2 texel = candidates.texels[k];
  if (isCurved(candidate(candidates, k)) && hasSurface(layer, texel)) return texel;
#endif
  return now;
}

// Nearest surface at the pixel at time t. Each kind of candidate is needed: without the taps the slower one of two moving
// surfaces is missed, without the taps on the other side a slower surface against the dominant motion, and without `second` a
// surface across the dominant motion (docs/derivations.md, "Which displacements to try").
Nearest sampleAt(ivec2 pixel, Own own, Candidates candidates, bool background, float t) {
  ivec2 size = textureSize(color_tex, 0);
  Nearest nearest = Nearest(kNothing, pixel, 0.0, false);
  for (int k = 0; k < candidates.count; ++k) {
    Path path = candidate(candidates, k);
    float tolerance_px = candidates.tolerance_px[k];
    vec2 offset = tapOffset(path, t);
    ivec2 now = pixel + roundSymmetric(offset), start = startAt(kRaster, candidates, k, now);
    if (!isInside(start, size)) continue;
    if (isInside(now, size)) nearest.at_silhouette = nearest.at_silhouette || isAtSilhouette(pixel, now, offset, t);
    nearest = nearerRaster(nearest, own, pixel, start, t, tolerance_px);
    if (!background) continue;
    start = startAt(kRevealed, candidates, k, now);
    if (isInside(start, size)) nearest = nearerRevealed(nearest, pixel, start, t, tolerance_px);
  }
  return nearest;
}

// True if a moving surface may be at the cell's pixels at some time.
// Colour of the surface found. With taps = linear, the bilinear mean of the four texels around the sample that are at the pixel
// at time t too, within 1.5 px; corners of weight below 1e-3 are skipped. `alike`: with marks_contrast, false if one of the
// four is missing or their contrast is above `contrast`; always true above `detail_below` px per sample. `color_range`: range
// of their colours; with WRITES_ESTIMATE, raster colours stand in for missing texels.
vec3 colorFound(Nearest nearest, ivec2 pixel, float t, out bool alike, out ColorRange color_range) {
  alike = true;
  color_range = emptyColorRange();
#if PARAM_taps == taps_linear || PARAM_marks_contrast
  bool after = t > 0.0;
  vec2 offset = tapOffset(pathOf(nearest.layer, nearest.now, after), t);
  vec2 low = floor(offset), share = offset - low;
  ivec2 first = pixel + wholeOf(low);
  vec3 sum = vec3(0);
  float weights = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1), at = first + corner;
    vec2 part = mix(1.0 - share, share, equal(corner, ivec2(1)));
    float weight = part.x * part.y;
    if (weight < 1e-3) continue;
    if (!hasSurface(nearest.layer, at) || !isAt(pixel, at, pathOf(nearest.layer, at, after), t, 1.5)) {
      alike = false;
#ifdef WRITES_ESTIMATE
      color_range = withColor(color_range, colorOf(kRaster, clampToImage(at, textureSize(color_tex, 0))));
#endif
      continue;
    }
    vec3 color = colorOf(nearest.layer, at);
    color_range = withColor(color_range, color);
    sum += weight * toSum(color);
    weights += weight;
  }
#endif
#if PARAM_marks_contrast
  bool fine = lengthOf(pathOf(nearest.layer, nearest.now, after).d) <= params.detail_below * float(params.samples);
  alike = !fine || (alike && isNarrow(color_range, params.contrast));
#endif
#if PARAM_taps == taps_linear
  if (weights > 0.0) return fromSum(sum / weights);
#endif
  return colorOf(nearest.layer, nearest.now);
}

// True if the surface found is the static raster surface of the pixel itself. Its colour is the colour of this texel.
bool isOwnAtRest(Own own, Nearest nearest, ivec2 pixel, float t) {
  Path path = rasterPath(own, pixel, pixel, t > 0.0);
  return nearest.layer == kRaster && nearest.now == pixel && path.d == vec2(0) && !isCurved(path);
}

// ---- unresolved samples

// Largest number of strata in `unreliable`: one word of 32 bits per cell.
const int kStrata = 32;

uvec2 partOf(int i) { return partBit(params.samples > kMostParts ? i * kMostParts / params.samples : i); }

uvec2 openOf(uint unreliable) {
  if (params.samples <= kStrata) return uvec2(unreliable, 0u);
  int parts = min(params.samples, kMostParts);
  uvec2 unresolved = uvec2(0u);
  for (int k = 0; k < parts && unreliable != 0u; ++k) {
    if ((unreliable >> uint(k * kStrata / parts) & 1u) != 0u) unresolved |= partBit(k);
  }
  return unresolved;
}

// Fallback estimate of the unresolved samples. Its expected error is the sum of three terms. Samples between texels of high
// contrast: a share of that contrast, with independent signs from texel to texel along the path. Samples of an unreliable
// layer: a share of the range of all colours at the pixel. Samples without a surface: the whole range, black included.
struct Estimate {
  vec3 sum;
  float squares;  // squared contrasts, times the number of samples between the same texels
  int unreliable;    // samples with unreliable layers
  int unknown;    // samples without a surface in any layer
};

// Error of a sample as a share of the contrast of the texels around it. Near 1/sqrt(12) = 0.289, the standard deviation of a
// value with a uniform distribution between two texels; no derivation is recorded.
const float kBetweenTexels = 0.3;

// Error of a sample with unreliable layers, as a share of the colour range at the pixel: as if an eighth of these samples were
// off by the whole range. No derivation is recorded. Both shares only set the order of pixels in experiments/ray_budget.
const float kUnreliable = 0.125;

float mostOf(vec3 value) { return max(value.r, max(value.g, value.b)); }

float widthOf(ColorRange color_range) { return max(mostOf(color_range.high - color_range.low), 0.0); }

Estimate withEstimate(Estimate fallback_estimate, vec3 color, ColorRange color_range, Path path, bool is_found,
                      bool is_unreliable) {
  fallback_estimate.sum += toSum(color);
  fallback_estimate.unknown += is_found ? 0 : 1;
  fallback_estimate.unreliable += is_found && is_unreliable ? 1 : 0;
  if (!is_found || is_unreliable) return fallback_estimate;
  float apart = kBetweenTexels * widthOf(color_range), n = float(params.samples);
  fallback_estimate.squares += apart * apart * n / clamp(lengthOf(path.d), 1.0, n);
  return fallback_estimate;
}

float offBy(Estimate fallback_estimate, ColorRange all_hit) {
  float unreliable = kUnreliable * float(fallback_estimate.unreliable) * widthOf(all_hit);
  float unknown = float(fallback_estimate.unknown) * widthOf(withColor(all_hit, vec3(0)));
  return (sqrt(fallback_estimate.squares) + unreliable + unknown) / float(params.samples);
}

void finishEstimate(ivec2 pixel, vec3 part, float off_by) {
#ifdef WRITES_ESTIMATE
  imageStore(fallback_estimate_img, pixel, vec4(part, off_by));
#endif
}

// Write the outputs. `part`: sum of the resolved samples over N. `share`: share of the samples that are resolved.
void finish(ivec2 pixel, vec3 part, float share, uvec2 unresolved) {
#if PARAM_marks_unresolved
  imageStore(unresolved_img, pixel, uvec4(unresolved, 0u, 0u));
#endif
  imageStore(blurred_img, pixel, vec4(part, share));
}

void run(ivec2 pixel) {
  ivec2 cell = pixel / params.cell_side;
  const uvec2 all_unresolved = allParts(params.samples);
  uvec2 unresolved = openOf(unreliable_at(cell).x);
  if (unresolved == all_unresolved && !kWritesEstimate) {
    finish(pixel, vec3(0), 0.0, unresolved);
    return;
  }
  if (moved_at(cell).x <= 0.5) {
    float share = 1.0 - float(countParts(unresolved)) / float(min(params.samples, kMostParts));
    vec3 color = vec3(color_at(pixel));
    finishEstimate(pixel, (1.0 - share) * color, (1.0 - share) * mostOf(finiteColor(vec4(color, 1))));
    finish(pixel, share * color, share, unresolved);
    return;
  }

  ivec2 tile = pixel / params.tile;
  bool background = background_at(cell).x > 0.5;
  float jitter = jitterOf(pixel);
  Candidates before = candidatesOf(pixel, dominantBefore(tile), jitter, background, false), after = before;
#if HAS_velocity_post
  after = candidatesOf(pixel, dominantAfter(tile), jitter, background, true);
#endif
  if (PARAM_marks_unresolved != 0 && (before.overflowed || after.overflowed || unlisted_at(cell).x > 0.5)) {
    unresolved = all_unresolved;
    finish(pixel, vec3(0), 0.0, unresolved);
    if (!kWritesEstimate) return;
  }

  Own own = ownOf(pixel);
  vec3 sum = vec3(0);
  ColorRange all_hit = emptyColorRange();
  Estimate fallback_estimate = Estimate(vec3(0), 0.0, 0, 0);
  uint left_out = 0u, fallbacks = 0u;
  for (int i = 0; i < params.samples; ++i) {
    bool is_unreliable = hasParts(unresolved & partOf(i));
    if (is_unreliable && !kWritesEstimate) {
      left_out += 1u;
      continue;
    }
    float t = sampleTime(i, params.samples, jitter);
    Nearest nearest = sampleAt(pixel, own, t > 0.0 ? after : before, background, t);
    bool is_found = nearest.layer != kNothing, is_known = is_found && !nearest.at_silhouette, alike = true;
    if (!is_known) fallbacks += 1u;
    if (!is_known && !(kWritesEstimate && is_found)) nearest.layer = isRevealed(pixel) ? kRevealed : kRaster;
    ColorRange color_range = emptyColorRange();
    bool is_asked = is_known || PARAM_marks_unresolved == 0 || kWritesEstimate;
    vec3 color = vec3(0);
    if (isOwnAtRest(own, nearest, pixel, t)) color = own.color;
    else if (is_asked) color = colorFound(nearest, pixel, t, alike, color_range);
    if (is_unreliable || (PARAM_marks_unresolved != 0 && !(is_known && (alike || PARAM_marks_contrast == 0)))) {
      unresolved |= partOf(i);
      left_out += 1u;
      if (kWritesEstimate) {
        fallback_estimate = withEstimate(fallback_estimate, color, color_range,
                                         pathOf(nearest.layer, nearest.now, t > 0.0), is_found, is_unreliable);
        all_hit = withColor(all_hit, color);
      }
      continue;
    }
    sum += toSum(color);
    all_hit = withColor(all_hit, color);
  }
  if (fallbacks > 0u) count_fallback(fallbacks);
  float n = float(params.samples);
  vec3 mean = fromSum(sum / n);
  if (left_out == 0u && isNarrow(all_hit, 0.0)) mean = all_hit.low;  // equal colours: exact, without the rounding of a sum
  if (left_out > 0u)
    finishEstimate(pixel, fromSum(fallback_estimate.sum / n),
                   offBy(fallback_estimate, withColor(all_hit, colorOf(kRaster, pixel))));
  finish(pixel, mean, 1.0 - float(left_out) / n, unresolved);
}
