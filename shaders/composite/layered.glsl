// SPDX-License-Identifier: MIT
// Per-time layered composite: the mean over the time samples of the nearest surface of both layers that is at the pixel at each
// time (an extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Per-time layered gather").
// In:  color, depth: raster layer, linear; view depth, metres, +inf for the sky.
//      velocity, dominant, second: displacement d per pixel; per tile, the longest and another one; px over the exposure.
//      revealed_color, _depth, _velocity, _dominant: the same images of the revealed layer; _valid: > 1/2 if present.
//      after_*, revealed_after_*: displacements after the raster time (absent: as before it).
//      curve, revealed_curve, dominant_curve, dominant_place: deviation of paths from lines, px; texel of dominant (optional).
//      moved, behind: per cell, > 1/2 where a moving (a revealed) surface is at some time (absent: everywhere).
//      missed: per cell, > 1/2 where a surface may arrive that the displacements of the tile do not lead to.
//      doubtful: per cell, bit i is set if the layers are unreliable at stratum i of at most 32.
//      silhouettes: > 1/2 next to a texel with a different displacement.
// Out: blurred: linear, alpha 1; with `leaves_open` the sum of the resolved samples over N, alpha: their share. Equals color in
//        cells without motion.
//      open: bit i is set if stratum i of at most 64 is unresolved.
//      guess: with GUESSES, a fallback estimate of the unresolved samples, over N; alpha: its expected error (see Guess).
// Method: at each midpoint t_i = (i + 1/2 + jitter)/N of the exposure, each candidate displacement g leads to the texel
//   Y = X - t_i*g of both layers. Y is at X if |Y + t_i*d(Y) - X| <= max(3/4, .99 min(|g|, |d(Y)|)/(2N)) px (see Constants). If
//   not, d(Y) leads to one more texel, on curves to three. The nearest texel at X counts, at equal depths the first one found.
//   Candidates: the displacements of the tile; d of both layers at X and, with `harvest`, at X +- t_i*g for g = dominant and
//   second, nearest first. At most 4 that differ by more than 1/2 px, others after the raster time in a split exposure.
//   No surface: the texel of X, revealed or raster (counter `fallback`). With `leaves_open` the sample is unresolved, as are
//   unreliable samples, samples beside a silhouette, and pixels with too many candidates; with `leaves_unlike` also samples
//   between texels with a contrast above `unlike`, of surfaces that move by less than `detail_below` px per sample.
// Fails: surfaces hidden at the raster time and not revealed (a second layer); paths that deviate, or surfaces that grow, by
//   more than the tolerance; more than 4 different motions at a pixel.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/candidates.glsl"
#include "lib/parts.glsl"
#include "lib/spread.glsl"
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
//   2 px and by more than sqrt(.02) = .14 of its length, as in shaders/tile/motion_reach.glsl. No derivation is recorded.
// 1.5 px (isUnsure, colorFound): a sample lies at most sqrt(2) = 1.41 px from the texels of its bilinear footprint. The rest
//   allows for displacements that vary over a surface.

// True if unresolved samples get a fallback estimate: the layers are then searched at these samples too.
#ifdef GUESSES
const bool kIsGuessed = true;
#else
const bool kIsGuessed = false;
#endif

// Depths that differ by less than 2^-16 of the depth count as equal: rays and raster find one surface at depths that differ by
// rounding. 2^-16 is 128 to 256 units in the last place of a float.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// A sample within this distance of a texel's centre along an axis, px, reads no texel beside it. 1e-3: the texels beside then
// have weights below 1e-3, which colorFound skips. 0.05: no derivation is recorded.
const float kCentre = PARAM_leaves_unlike != 0 ? 1e-3 : 0.05;

struct Seen {
  int layer;
  ivec2 now;  // texel of its layer, at the raster time
  float depth;
  bool unsure;  // a moving silhouette may pass between the texels around it
};

// --- Surfaces at a pixel
// ----------------------------------------------------------------------------------------------------------------

Seen nearer(Seen seen, int layer, ivec2 now, float depth) {
  if (seen.layer != kNothing && depth >= seen.depth * kSameDepth) return seen;
  return Seen(layer, now, depth, seen.unsure);
}

// Raster surface at the pixel itself, where most searches end. Read once.
struct Own {
  Path before, after;
  float depth;
  vec3 color;
};

Own ownOf(ivec2 pixel) {
  float depth = saneDepth(texelFetch(depth_tex, pixel, 0).x);
  return Own(pathOf(kRaster, pixel, false), pathOf(kRaster, pixel, true), depth, colorOf(kRaster, pixel));
}

Path rasterPath(Own own, ivec2 pixel, ivec2 now, bool after) {
  if (now != pixel) return pathOf(kRaster, now, after);
  if (after) return own.after;
  return own.before;
}

float rasterDepth(Own own, ivec2 pixel, ivec2 now) {
  return now == pixel ? own.depth : saneDepth(texelFetch(depth_tex, now, 0).x);
}

Seen nearerRaster(Seen seen, Own own, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurvedGuesses; ++i) {
    Path path = rasterPath(own, pixel, now, after);
    if (isThere(pixel, now, path, t, tolerance_px))
      return nearer(seen, kRaster, now, rasterDepth(own, pixel, now));
    if (!isAskedAgain(i, path)) break;
    ivec2 next = askedOf(kRaster, pixel, now, path, t);
    if (next == now || !isInside(next, textureSize(color_tex, 0))) break;
    now = next;
  }
  return seen;
}

Seen nearerRevealed(Seen seen, ivec2 pixel, ivec2 now, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurvedGuesses && isRevealed(now); ++i) {
    Path path = pathOf(kRevealed, now, after);
    if (isThere(pixel, now, path, t, tolerance_px)) return nearer(seen, kRevealed, now, revealedDepth(now));
    if (!isAskedAgain(i, path)) break;
    ivec2 next = askedOf(kRevealed, pixel, now, path, t);
    if (next == now || !isInside(next, textureSize(color_tex, 0))) break;
    now = next;
  }
  return seen;
}

// True if a moving silhouette may pass between the texels around a sample. With leaves_unlike: if their displacements differ
// (movesOtherwise). Otherwise: if some of these texels are at the pixel at time t, within 1.5 px, and some are not.
bool isUnsure(ivec2 pixel, ivec2 now, vec2 offset, float t) {
#if HAS_silhouettes
  vec2 off_centre = offset - vec2(now - pixel);
  ivec2 beside = ivec2(greaterThan(off_centre, vec2(kCentre))) - ivec2(lessThan(off_centre, vec2(-kCentre)));
  if (beside == ivec2(0) || texelFetch(silhouettes_tex, now, 0).x < 0.5) return false;
  ivec2 size = textureSize(color_tex, 0);
#if PARAM_leaves_unlike
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
#else
  return false;
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
Seen seenAt(ivec2 pixel, Own own, Candidates candidates, bool behind, float t) {
  ivec2 size = textureSize(color_tex, 0);
  Seen seen = Seen(kNothing, pixel, 0.0, false);
  for (int k = 0; k < candidates.count; ++k) {
    Path path = candidate(candidates, k);
    float tolerance_px = candidates.tolerance_px[k];
    vec2 offset = tapOffset(path, t);
    ivec2 now = pixel + roundSymmetric(offset), start = startAt(kRaster, candidates, k, now);
    if (!isInside(start, size)) continue;
    if (isInside(now, size)) seen.unsure = seen.unsure || isUnsure(pixel, now, offset, t);
    seen = nearerRaster(seen, own, pixel, start, t, tolerance_px);
    if (!behind) continue;
    start = startAt(kRevealed, candidates, k, now);
    if (isInside(start, size)) seen = nearerRevealed(seen, pixel, start, t, tolerance_px);
  }
  return seen;
}

// True if a moving surface may be at the cell's pixels at some time.
bool isMoved(ivec2 cell) {
#if HAS_moved
  return texelFetch(moved_tex, cell, 0).x > 0.5;
#else
  return true;
#endif
}

bool isMissed(ivec2 cell) {
#if HAS_missed
  return texelFetch(missed_tex, cell, 0).x > 0.5;
#else
  return false;
#endif
}

// Strata with unreliable layers, a bit each.
uint doubtful(ivec2 cell) {
#if HAS_doubtful
  return texelFetch(doubtful_tex, cell, 0).x;
#else
  return 0u;
#endif
}

bool isBehind(ivec2 cell) {
#if HAS_behind
  return texelFetch(behind_tex, cell, 0).x > 0.5;
#else
  return true;
#endif
}

// Colour of the surface found. With taps = linear, the bilinear mean of the four texels around the sample that are at the pixel
// at time t too, within 1.5 px; corners of weight below 1e-3 are skipped. `alike`: with leaves_unlike, false if one of the four
// is missing or their contrast is above `unlike`; always true above `detail_below` px per sample. `spread`: range of their
// colours; with GUESSES, raster colours stand in for missing texels.
vec3 colorFound(Seen seen, ivec2 pixel, float t, out bool alike, out Spread spread) {
  alike = true;
  spread = noSpread();
#if PARAM_taps == taps_linear || PARAM_leaves_unlike
  bool after = t > 0.0;
  vec2 offset = tapOffset(pathOf(seen.layer, seen.now, after), t);
  vec2 low = floor(offset), share = offset - low;
  ivec2 first = pixel + wholeOf(low);
  vec3 sum = vec3(0);
  float weights = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1), at = first + corner;
    vec2 part = mix(1.0 - share, share, equal(corner, ivec2(1)));
    float weight = part.x * part.y;
    if (weight < 1e-3) continue;
    if (!hasSurface(seen.layer, at) || !isAt(pixel, at, pathOf(seen.layer, at, after), t, 1.5)) {
      alike = false;
#ifdef GUESSES
      spread = withColor(spread, colorOf(kRaster, clampToImage(at, textureSize(color_tex, 0))));
#endif
      continue;
    }
    vec3 color = colorOf(seen.layer, at);
    spread = withColor(spread, color);
    sum += weight * toSum(color);
    weights += weight;
  }
#endif
#if PARAM_leaves_unlike
  bool fine = lengthOf(pathOf(seen.layer, seen.now, after).d) <= params.detail_below * float(params.samples);
  alike = !fine || (alike && isNarrow(spread, params.unlike));
#endif
#if PARAM_taps == taps_linear
  if (weights > 0.0) return fromSum(sum / weights);
#endif
  return colorOf(seen.layer, seen.now);
}

// True if the surface found is the static raster surface of the pixel itself. Its colour is the colour of this texel.
bool isOwnAtRest(Own own, Seen seen, ivec2 pixel, float t) {
  Path path = rasterPath(own, pixel, pixel, t > 0.0);
  return seen.layer == kRaster && seen.now == pixel && path.d == vec2(0) && !isCurved(path);
}

// ---- unresolved samples

// Largest number of strata in `doubtful`: one word of 32 bits per cell.
const int kDoubtParts = 32;

uvec2 partOf(int i) { return partBit(params.samples > kMostParts ? i * kMostParts / params.samples : i); }

uvec2 openOf(uint doubts) {
  if (params.samples <= kDoubtParts) return uvec2(doubts, 0u);
  int parts = min(params.samples, kMostParts);
  uvec2 open = uvec2(0u);
  for (int k = 0; k < parts && doubts != 0u; ++k) {
    if ((doubts >> uint(k * kDoubtParts / parts) & 1u) != 0u) open |= partBit(k);
  }
  return open;
}

// Fallback estimate of the unresolved samples. Its expected error is the sum of three terms. Samples between texels of high
// contrast: a share of that contrast, with independent signs from texel to texel along the path. Samples of an unreliable
// layer: a share of the range of all colours at the pixel. Samples without a surface: the whole range, black included.
struct Guess {
  vec3 sum;
  float squares;  // squared contrasts, times the number of samples between the same texels
  int doubted;    // samples with unreliable layers
  int unknown;    // samples without a surface in any layer
};

// Error of a sample as a share of the contrast of the texels around it. Near 1/sqrt(12) = 0.289, the standard deviation of a
// value with a uniform distribution between two texels; no derivation is recorded.
const float kBetweenTexels = 0.3;

// Error of a sample with unreliable layers, as a share of the colour range at the pixel: as if an eighth of these samples were
// off by the whole range. No derivation is recorded. Both shares only set the order of pixels in experiments/ray_budget.
const float kDoubted = 0.125;

float mostOf(vec3 value) { return max(value.r, max(value.g, value.b)); }

float widthOf(Spread spread) { return max(mostOf(spread.high - spread.low), 0.0); }

Guess withGuess(Guess guess, vec3 color, Spread spread, Path path, bool is_found, bool is_doubted) {
  guess.sum += toSum(color);
  guess.unknown += is_found ? 0 : 1;
  guess.doubted += is_found && is_doubted ? 1 : 0;
  if (!is_found || is_doubted) return guess;
  float apart = kBetweenTexels * widthOf(spread), n = float(params.samples);
  guess.squares += apart * apart * n / clamp(lengthOf(path.d), 1.0, n);
  return guess;
}

float offBy(Guess guess, Spread all_seen) {
  float doubted = kDoubted * float(guess.doubted) * widthOf(all_seen);
  float unknown = float(guess.unknown) * widthOf(withColor(all_seen, vec3(0)));
  return (sqrt(guess.squares) + doubted + unknown) / float(params.samples);
}

void finishGuess(ivec2 pixel, vec3 part, float off_by) {
#ifdef GUESSES
  imageStore(guess_img, pixel, vec4(part, off_by));
#endif
}

// Write the outputs. `part`: sum of the resolved samples over N. `share`: share of the samples that are resolved.
void finish(ivec2 pixel, vec3 part, float share, uvec2 open) {
#if PARAM_leaves_open
  imageStore(open_img, pixel, uvec4(open, 0u, 0u));
#endif
  imageStore(blurred_img, pixel, vec4(part, share));
}

void run(ivec2 pixel) {
  ivec2 cell = pixel / params.cell_side;
  const uvec2 all_open = allParts(params.samples);
  uvec2 open = openOf(doubtful(cell));
  if (open == all_open && !kIsGuessed) {
    finish(pixel, vec3(0), 0.0, open);
    return;
  }
  if (!isMoved(cell)) {
    float share = 1.0 - float(countParts(open)) / float(min(params.samples, kMostParts));
    vec3 color = vec3(texelFetch(color_tex, pixel, 0));
    finishGuess(pixel, (1.0 - share) * color, (1.0 - share) * mostOf(finiteColor(vec4(color, 1))));
    finish(pixel, share * color, share, open);
    return;
  }

  ivec2 tile = pixel / params.tile;
  bool behind = isBehind(cell);
  float jitter = jitterOf(pixel);
  Candidates before = candidatesOf(pixel, dominantBefore(tile), jitter, behind, false), after = before;
#if HAS_after_velocity
  after = candidatesOf(pixel, dominantAfter(tile), jitter, behind, true);
#endif
  if (PARAM_leaves_open != 0 && (before.crowded || after.crowded || isMissed(cell))) {
    open = all_open;
    finish(pixel, vec3(0), 0.0, open);
    if (!kIsGuessed) return;
  }

  Own own = ownOf(pixel);
  vec3 sum = vec3(0);
  Spread all_seen = noSpread();
  Guess guess = Guess(vec3(0), 0.0, 0, 0);
  uint left_out = 0u, fallbacks = 0u;
  for (int i = 0; i < params.samples; ++i) {
    bool is_doubted = hasParts(open & partOf(i));
    if (is_doubted && !kIsGuessed) {
      left_out += 1u;
      continue;
    }
    float t = sampleTime(i, params.samples, jitter);
    Seen seen = seenAt(pixel, own, t > 0.0 ? after : before, behind, t);
    bool is_found = seen.layer != kNothing, is_known = is_found && !seen.unsure, alike = true;
    if (!is_known) fallbacks += 1u;
    if (!is_known && !(kIsGuessed && is_found)) seen.layer = isRevealed(pixel) ? kRevealed : kRaster;
    Spread spread = noSpread();
    bool is_asked = is_known || PARAM_leaves_open == 0 || kIsGuessed;
    vec3 color = vec3(0);
    if (isOwnAtRest(own, seen, pixel, t)) color = own.color;
    else if (is_asked) color = colorFound(seen, pixel, t, alike, spread);
    if (is_doubted || (PARAM_leaves_open != 0 && !(is_known && (alike || PARAM_leaves_unlike == 0)))) {
      open |= partOf(i);
      left_out += 1u;
      if (kIsGuessed) {
        guess = withGuess(guess, color, spread, pathOf(seen.layer, seen.now, t > 0.0), is_found, is_doubted);
        all_seen = withColor(all_seen, color);
      }
      continue;
    }
    sum += toSum(color);
    all_seen = withColor(all_seen, color);
  }
  if (fallbacks > 0u) count_fallback(fallbacks);
  float n = float(params.samples);
  vec3 mean = fromSum(sum / n);
  if (left_out == 0u && isNarrow(all_seen, 0.0)) mean = all_seen.low;  // equal colours: exact, without the rounding of a sum
  if (left_out > 0u) finishGuess(pixel, fromSum(guess.sum / n), offBy(guess, withColor(all_seen, colorOf(kRaster, pixel))));
  finish(pixel, mean, 1.0 - float(left_out) / n, open);
}
