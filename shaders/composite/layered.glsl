// SPDX-License-Identifier: MIT
// Per-time layered composite: for each time sample, the nearest surface of any layer that really is at the pixel then.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure), dominant (the same, per tile) of
//      what raster saw; second (per tile): another displacement found around; revealed_color, revealed_depth,
//      revealed_velocity, revealed_valid (> 1/2) of what lies behind; revealed_dominant: where that layer has its own;
//      after_*, revealed_after_*: the same displacements for the times after the capture, where the exposure is split
//      there (absent: motion is linear throughout). d(Y) and the candidates are then those of the part that t_i is in;
//      moved, behind (> 1/2, per cell): something that moves, something revealed may be at its pixels at some time
//      (absent: everywhere); missed (> 1/2, per cell): something comes that no displacement of the tile leads to;
//      doubtful (a bit for each sample, per cell): what comes then is not where layers say; silhouettes (> 1/2: next to
//      something that moves otherwise).
// Out: blurred (linear, alpha 1). Where nothing moved it is color. With `leaves_open`: of the samples that layers explain, the
//      sum over the number of all, and in alpha their share; open: a bit for each of the others (of more than 64 samples one
//      for several). guess (layered_guessing.glsl alone): of what is left open the sum over the number of all of what layers
//      say nevertheless, and in alpha by how much that may be off (Guess).
// For t_i at the midpoints (i + 1/2 + jitter)/N of the exposure: each candidate displacement g says where a surface
//   that is at X at t_i would be now, Y = X - t_i*g. A texel Y of a layer is at X then if |Y + t_i*d(Y) - X| <=
//   max(3/4, .99 min(|g|, |d(Y)|)/(2N)) (3/4 px: the rounding of Y); one that is not leads to a second guess, by its own d.
//   The nearest texel that is there is what X shows at t_i; of equal depths the earlier candidate
//   and the raster layer win. The mean over i is the result: weights add up to 1 by construction, order in depth and
//   correlation of movements come out right.
// Candidates: the tile's displacements (dominant, second, revealed), those of X in all layers, and those met in all
//   layers (those behind where they may be at X) at the taps X - t_i*d along d = dominant and second, and at X + t_i*d, as
//   far as they differ by more than half a pixel from all before; kMaxCandidates in all. Without the taps the slower of
//   two moving surfaces is missed, without those to the other side a slower one that moves against the dominant one,
//   without `second` one that crosses it.
// If no layer has anything at X at t_i, it is what was revealed at X, else what raster saw there (counter `fallback`); with
//   `leaves_open` the sample is left open, as are those beside a silhouette, and all of a pixel with more motions than
//   candidates; with `leaves_unlike` those too between texels that differ by more than the share `unlike`, if
//   samples are less than `detail_below` px apart.
// Fails: surfaces hidden at the capture and not revealed (second layer and beyond); motion that bends or magnifies by
//   more than the tolerance within the distance moved; more motions at one pixel than candidates.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/candidates.glsl"
#include "lib/parts.glsl"
#include "lib/spread.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

// Do samples that are left open have a guess? Then layers are asked for each.
#ifdef GUESSES
const bool kIsGuessed = true;
#else
const bool kIsGuessed = false;
#endif

// Rays and raster find one surface at depths that differ by rounding: nearer by less than this share is equal.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// A tap this near to a texel's centre is what the texel says, px.
const float kCentre = PARAM_leaves_unlike != 0 ? 1e-3 : 0.05;

struct Seen {
  int layer;
  ivec2 now;  // where it is at the capture
  float depth;
  bool unsure;  // a silhouette passes within a pixel
};

// --- What is at a pixel
// ----------------------------------------------------------------------------------------------------------------

Seen nearer(Seen seen, int layer, ivec2 now, float depth) {
  if (seen.layer != kNothing && depth >= seen.depth * kSameDepth) return seen;
  return Seen(layer, now, depth, seen.unsure);
}

// What raster saw at the pixel itself, where most searches end: read once.
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

// Does a silhouette pass between the four texels around what is at a pixel, of which some then are there and some not?
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

// Where the search begins that a candidate leads to `now`: on curves at its texel, from which Newton's step leads farther.
ivec2 startAt(int layer, Candidates candidates, int k, ivec2 now) {
#if HAS_curve
  ivec2 texel = candidates.texels[k];
  if (isCurved(candidate(candidates, k)) && hasSurface(layer, texel)) return texel;
#endif
  return now;
}

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

// What of a cell may be at its pixels: something in motion, something revealed.
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

// A bit for each sample of which the layers are not asked.
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

// The colour of what was found: of the texel, or where the sample lies between the centres of four, of those of them that
// are there too. `alike`: all of these are, and look the same.
// `spread`: with GUESSES, of these and of what raster saw where others are missing.
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

// Is what was found what raster saw at the pixel, at rest? Its colour is that of the texel alone.
bool isOwnAtRest(Own own, Seen seen, ivec2 pixel, float t) {
  Path path = rasterPath(own, pixel, pixel, t > 0.0);
  return seen.layer == kRaster && seen.now == pixel && path.d == vec2(0) && !isCurved(path);
}

// ---- samples that are left open

// Those of a cell of which layers are not asked have a bit for each of at most so many parts.
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

// What layers say of samples that are left open. By how much they may be off: where texels differ by a part of that, to
// either side, at random from texel to texel of the way; where a layer is not to be trusted by a part of what all differs
// that the pixel sees; where nothing is known by all of that, black included.
struct Guess {
  vec3 sum;
  float squares;  // of differences between texels, each as often as samples fall between the same ones
  int doubted;    // samples at which no layer is to be trusted
  int unknown;    // samples at which none has anything
};

// Of the difference of the texels around a sample.
const float kBetweenTexels = 0.3;

// Of the difference of all that a pixel sees.
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

// `part`: of the picture, of the samples that are explained, of which `share` is that of all.
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
  if (left_out == 0u && isNarrow(all_seen, 0.0)) mean = all_seen.low;  // of equal colours not rounded
  if (left_out > 0u) finishGuess(pixel, fromSum(guess.sum / n), offBy(guess, withColor(all_seen, colorOf(kRaster, pixel))));
  finish(pixel, mean, 1.0 - float(left_out) / n, open);
}
