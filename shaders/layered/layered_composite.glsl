// SPDX-License-Identifier: MIT
// Per-time layered composite: at each time sample, the nearest surface of both layers at the pixel; the result is the mean over
// the samples (an extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Per-time layered gather").
// In:  `color`, `depth`: raster layer: linear radiance; view depth, metres, +inf for the sky
//      `velocity`: displacement d of each pixel; `dominant`, `second`: two displacements of each tile; px over the exposure
//      `revealed_color`, `_depth`, `_velocity`, `_dominant`: images of the revealed layer; `_valid`: > 1/2 where it exists
//      `velocity_post`, `dominant_post`, `second_post`, `revealed_*_post`: for times after the raster time; absent: unchanged
//      `curve`, `revealed_curve`, `dominant_curve`: curves of paths, px; `dominant_place`: texel with `dominant`; all optional
//      `moved`, `background`: per cell, > 1/2 if a moving (a revealed) surface is there at some time; absent: everywhere
//      `unlisted`: per cell, > 1/2 if a surface may arrive by a displacement that is not among the tile's displacements
//      `unreliable`: per cell, bit i is set if the layers may be wrong in stratum i of at most 32
//      `silhouettes`: > 1/2 next to a texel with a different displacement
// Out: `blurred`: linear radiance, alpha 1; with `marks_unresolved`: sum of the resolved samples, over N; alpha: their share
//      `unresolved`: bit i is set if any sample of stratum i of min(N, 64) is unresolved
//      `fallback_estimate`: sum of estimates of unresolved samples, over N; alpha: expected error (see Estimate); optional
// Method: at each time t_i = (i + 1/2 + jitter)/N of the exposure, i < N = `samples`, each candidate displacement g leads from
//   pixel X to texel Y = X - t_i*g of both layers. Y is at X if |Y + t_i*d(Y) - X| <= max(3/4, .99 min(|g|, |d(Y)|)/(2N)) px
//   (Constants). Otherwise d(Y) leads to one more texel, on curves to three. The nearest texel at X counts.
//   Candidates: the tile's displacements; d of both layers at X and, with `search_taps`, at X +- t_i*g for the two
//   displacements g of the tile, nearest taps first. At most 4 are kept, which differ by more than 1/2 px.
//   A sample without a surface takes the texel of X (counter `fallback`); with `marks_unresolved` it is unresolved. So are
//   samples with unreliable layers, at silhouettes, at pixels with too many candidates and, with `marks_contrast`, between
//   texels of high `contrast` on surfaces that move by at most `detail_below` px per sample.
// Fails: misses surfaces hidden at the raster time and not revealed, and motions beyond 4 at a pixel. Misplaces surfaces if
//   their paths deviate, or they stretch, by more than the tolerance.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/candidates.glsl"
#include "lib/parts.glsl"
#include "lib/color_range.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

// --- Constants
// ----------------------------------------------------------------------------------------------------------------
// Numbers of the Method, in mixin/candidates.glsl:
// - 3/4 px: rounding a position to a texel moves it by at most sqrt(1/2) = .71 px.
// - .99 min(|g|, |d(Y)|)/(2N): two successive time samples are |d|/N px apart. A texel half-way between them must count at
//   neither sample, so the tolerance is just below half of this distance. With an earlier tolerance of |g|/(2N), the pixel's
//   own foreground counted at the samples next to the raster time. With up to four samples and motion above 10 px, the error
//   was then up to twice the error of ground truth with as many samples. Now it is at most 1.05 times that error (237c3545, the
//   test RenderPassage).
// - 1/4 px^2: two candidates count as one up to this squared difference. Two candidates within 1/2 px of each other lead to
//   places at most 1/2 px apart, since |t| <= 1.
// - 4 px^2, .02 |d|^2: a fifth candidate d makes the list overflow if it differs from each of the four by more than 2 px and by
//   more than sqrt(.02) = .14 of its length, as in shaders/cell/classify_cells.glsl. No derivation is recorded.
// Number in isAtSilhouette and colorFound:
// - 1.5 px: a sample lies at most sqrt(2) = 1.41 px from the texels of its bilinear footprint. The rest allows for
//   displacements that vary over a surface.

// True if unresolved samples get a fallback estimate. The composite then searches surfaces at the times of these samples too.
#ifdef WRITES_ESTIMATE
const bool kWritesEstimate = true;
#else
const bool kWritesEstimate = false;
#endif

// Factor for the comparison of depths: depths that differ by less than 2^-16 of the depth count as equal, because rays and
// raster compute the depth of one surface with different rounding errors. 2^-16 is 128 to 256 units in the last place of a
// float.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// Largest distance along an axis, px, between a sample and the centre of its nearest texel, such that the neighbour along this
// axis is not tested for a silhouette. At 1e-3, such neighbours have weights below 1e-3, which colorFound skips. For 0.05, no
// derivation is recorded.
const float kCentre = PARAM_marks_contrast != 0 ? 1e-3 : 0.05;

// Nearest surface at the pixel at one time sample, of the candidates tried so far.
struct Nearest {
  int layer;           // kNothing, kRaster or kRevealed
  ivec2 now;           // texel of the layer that shows the surface at the raster time
  float depth;         // view depth at the raster time, metres
  bool at_silhouette;  // a moving silhouette may lie between the texels around the sample
};

// --- Surfaces at a pixel
// ----------------------------------------------------------------------------------------------------------------

Nearest nearer(Nearest nearest, int layer, ivec2 now, float depth) {
  if (nearest.layer != kNothing && depth >= nearest.depth * kSameDepth) return nearest;
  return Nearest(layer, now, depth, nearest.at_silhouette);
}

// Raster surface at the pixel itself. Most searches end there, so the surface is read once for all time samples.
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

// `nearest` or, if nearer, the surface of the raster layer at the pixel at time t. The search begins at the texel `now`.
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

// `nearest` or, if nearer, the surface of the revealed layer at the pixel at time t. The search begins at the texel `now`.
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

// True if a moving silhouette may lie between the four texels around a sample, so that the sample may be on either side. `now`:
// texel nearest to the sample. `offset`: position of the sample relative to the pixel, px. With marks_contrast: true if the
// displacements of the texels differ (movesOtherwise). Otherwise: true if some of the texels, but not all, are at the pixel at
// time t, within 1.5 px.
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

// Texel where the search with candidate k begins. Without a curve, it is `now`, the texel that the candidate's displacement
// leads to. With a curve, it is the texel that has this curve, because Newton's method finds more distant surfaces from there.
ivec2 startAt(int layer, Candidates candidates, int k, ivec2 now) {
#if HAS_curve
  ivec2 texel = candidates.texels[k];
  if (isCurved(candidate(candidates, k)) && hasSurface(layer, texel)) return texel;
#endif
  return now;
}

// Nearest surface at the pixel at time t. `background`: search the revealed layer too.
// Each kind of candidate is needed (docs/derivations.md, "Candidate displacements"):
// - Without the taps along the motion, the slower one of two moving surfaces is missed.
// - Without taps on both sides of the pixel, a slower surface that moves against the dominant motion is missed.
// - Without `second`, a surface that moves across the dominant motion is missed.
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

// Colour of the surface `nearest` at the pixel at time t, linear radiance. With taps = nearest, it is the colour of the texel
// `nearest.now`. With taps = linear, it is the bilinear mean of the four texels around the sample. The mean leaves out texels
// that are not at the pixel at time t, within 1.5 px, and texels with a weight below 1e-3.
// `alike`: true with taps = nearest and without marks_contrast. Otherwise false if a texel with a larger weight is left out.
// With marks_contrast, it is also false if the contrast of the texels is above the parameter `contrast`. With marks_contrast,
// it is always true for surfaces that move by more than `detail_below` px between two samples, because such samples are too
// sparse to show the contrast.
// `color_range`: range of the texels' colours. With WRITES_ESTIMATE, the colours of the raster layer replace texels left out.
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

// True if the surface found is the static raster surface of the pixel itself. Its colour is then the colour of the pixel's own
// texel, and no other texel is read.
bool isOwnAtRest(Own own, Nearest nearest, ivec2 pixel, float t) {
  Path path = rasterPath(own, pixel, pixel, t > 0.0);
  return nearest.layer == kRaster && nearest.now == pixel && path.d == vec2(0) && !isCurved(path);
}

// ---- unresolved samples

// Largest number of strata in the image `unreliable`, which has one word of 32 bits per cell.
const int kStrata = 32;

// Bit of the stratum of time sample i, for sets of at most 64 strata (lib/parts.glsl).
uvec2 partOf(int i) { return partBit(params.samples > kMostParts ? i * kMostParts / params.samples : i); }

// Set of the strata in which the layers are unreliable in a cell. All samples in these strata are unresolved. `unreliable`: the
// cell's word of 32 bits. With more than 32 strata (up to 64), adjacent strata share a bit of the word.
uvec2 openOf(uint unreliable) {
  if (params.samples <= kStrata) return uvec2(unreliable, 0u);
  int parts = min(params.samples, kMostParts);
  uvec2 unresolved = uvec2(0u);
  for (int k = 0; k < parts && unreliable != 0u; ++k) {
    if ((unreliable >> uint(k * kStrata / parts) & 1u) != 0u) unresolved |= partBit(k);
  }
  return unresolved;
}

// Fallback estimate of the unresolved samples of a pixel, and numbers for offBy, which computes the expected error of the
// estimate. The error is the sum of three terms:
// - for samples between texels of high contrast: the share kBetweenTexels of that contrast. Samples between the same texels
//   have equal errors; errors of different texels along the path have independent signs, so their squares add up.
// - for samples of an unreliable layer: the share kUnreliable of the range of all colours at the pixel.
// - for samples without a surface: the whole range, extended to black.
struct Estimate {
  vec3 sum;
  float squares;  // sum of squared errors, each times the number of samples between the same texels
  int unreliable;    // number of samples with unreliable layers
  int unknown;    // number of samples without a surface in any layer
};

// Expected error of a sample between texels, as a share of the difference of their colours. The value is near 1/sqrt(12) =
// 0.289, the standard deviation of a uniform distribution between the values of two texels; no derivation is recorded.
const float kBetweenTexels = 0.3;

// Expected error of a sample with unreliable layers, as a share of the colour range at the pixel: as if an eighth of these
// samples were off by the whole range. No derivation is recorded. The two shares kBetweenTexels and kUnreliable only affect the
// priority of pixels for rays in experiments/ray_budget.
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

// Expected error of the fallback estimate, linear radiance. `all_hit`: range of all colours at the pixel.
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

// Writes the outputs `blurred` and `unresolved`. `part`: sum of the resolved samples, divided by the number of all samples.
// `share`: share of the samples that are resolved.
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
  if (left_out == 0u && isNarrow(all_hit, 0.0)) mean = all_hit.low;  // the mean of equal colours is exact, without rounding
  if (left_out > 0u)
    finishEstimate(pixel, fromSum(fallback_estimate.sum / n),
                   offBy(fallback_estimate, withColor(all_hit, colorOf(kRaster, pixel))));
  finish(pixel, mean, 1.0 - float(left_out) / n, unresolved);
}
