// SPDX-License-Identifier: MIT
// Per-time layered composite: at each time sample, the nearest surface of both layers at the pixel; the result is the mean over
// the samples (an extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Per-time layered gather").
// In:  `color`, `depth`: raster layer: linear radiance; view depth, metres, +inf for the sky
//      `velocity`: displacement d of each pixel; `dominant`, `second`: two displacements of each tile; px over the exposure
//      `revealed_color`, `_depth`, `_velocity`, `_dominant`: images of the revealed layer; `_valid`: > 1/2 where it has
//        a surface
//      `velocity_post`, `dominant_post`, `second_post`, `revealed_*_post`: for times after the raster time; absent: unchanged
//      `curve`, `revealed_curve`, `dominant_curve`: curves of paths, px; `dominant_place`: texel with `dominant`; all optional
//      `moved`: per cell, > 1/2 if a moving surface is there at some time; absent: everywhere. Other cells are copied
//      `background`: per cell, > 1/2 if a revealed surface is there at some time; absent: everywhere
// Out: `blurred`: linear radiance, alpha 1
// Method: t_i is the time at the share (i + 1/2 + jitter)/N of the exposure, i < N = `samples`. For each t_i, candidate
//   displacement g and layer, search for a texel Y whose surface is at pixel X at t_i, by fixed-point iteration. First
//   test Y = X - t_i*g. Its surface is at X if |Y + t_i*d(Y) - X| <= max(3/4, .99 min(|g|, |d(Y)|)/(2N)) px (see
//   "Constants" below). Otherwise test one more texel, X - t_i*d(Y); on curved paths up to three more, by Newton's
//   method (mixin/search.glsl). The nearest surface found is the sample. If none is found, the sample is the texel at
//   X, from the revealed layer if that layer has a surface there (counter `fallback`).
//   Candidates g, in this order; at most 4 are kept, which differ by more than 1/2 px:
//   - the tile's displacements `dominant`, `second` and `revealed_dominant`;
//   - the displacements of both layers at X;
//   - with `search_taps`, those at the taps X + t_i*h and X - t_i*h, nearest first, for h = `dominant`, then `second`.
// Fails: misses surfaces hidden at the raster time and not revealed, and motions beyond 4 at a pixel. Misplaces surfaces if
//   their paths deviate, or they stretch, by more than the tolerance.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/candidates.glsl"
#include "lib/color_range.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

// --- Constants
// ----------------------------------------------------------------------------------------------------------------
// Numbers of the Method, in mixin/candidates.glsl:
// - 3/4 px: rounding a position to a texel moves it by at most sqrt(1/2) = .71 px.
// - .99 min(|g|, |d(Y)|)/(2N): two successive time samples are |d|/N px apart. A texel half-way between them must count
//   at neither sample, so the tolerance is just below half of this distance. With the tolerance |g|/(2N), the pixel's
//   own foreground would also count at the samples next to the raster time: with up to four samples and motion above 10
//   px, the error would be up to twice the error of ground truth with as many samples. With this tolerance, the error
//   is at most 1.05 times that error (printed by the test RenderPassage).
// - 1/4 px^2: two candidates count as one up to this squared difference. Two candidates within 1/2 px of each other lead to
//   places at most 1/2 px apart, since |t| <= 1.

// Factor for the comparison of depths: depths that differ by less than 2^-16 of the depth count as equal, because rays and
// raster compute the depth of one surface with different rounding errors. 2^-16 is 128 to 256 units in the last place of a
// float.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// Nearest surface at the pixel at one time sample, of the candidates tried so far.
struct Nearest {
  int layer;           // kNothing, kRaster or kRevealed
  ivec2 texel;         // texel of the layer that shows the surface at the raster time
  float depth;         // view depth at the raster time, metres
};

// --- Surfaces at a pixel
// ----------------------------------------------------------------------------------------------------------------

Nearest nearer(Nearest nearest, int layer, ivec2 texel, float depth) {
  if (nearest.layer != kNothing && depth >= nearest.depth * kSameDepth) return nearest;
  return Nearest(layer, texel, depth);
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

Path rasterPath(Own own, ivec2 pixel, ivec2 texel, bool after) {
  if (texel != pixel) return pathOf(kRaster, texel, after);
  if (after) return own.after;
  return own.before;
}

float rasterDepth(Own own, ivec2 pixel, ivec2 texel) {
  return texel == pixel ? own.depth : saneDepth(depth_at(texel).x);
}

// `nearest` or, if nearer, the surface of the raster layer at the pixel at time t. The search begins at `texel`.
Nearest nearerRaster(Nearest nearest, Own own, ivec2 pixel, ivec2 texel, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurveIterations; ++i) {
    Path path = rasterPath(own, pixel, texel, after);
    if (isThere(pixel, texel, path, t, tolerance_px))
      return nearer(nearest, kRaster, texel, rasterDepth(own, pixel, texel));
    if (!iteratesAgain(i, path)) break;
    ivec2 next = nextTexelOf(kRaster, pixel, texel, path, t);
    if (next == texel || !isInside(next, textureSize(color_tex, 0))) break;
    texel = next;
  }
  return nearest;
}

// `nearest` or, if nearer, the surface of the revealed layer at the pixel at time t. The search begins at `texel`.
Nearest nearerRevealed(Nearest nearest, ivec2 pixel, ivec2 texel, float t, float tolerance_px) {
  bool after = t > 0.0;
  for (int i = 0; i < kCurveIterations && isRevealed(texel); ++i) {
    Path path = pathOf(kRevealed, texel, after);
    if (isThere(pixel, texel, path, t, tolerance_px)) return nearer(nearest, kRevealed, texel, revealedDepth(texel));
    if (!iteratesAgain(i, path)) break;
    ivec2 next = nextTexelOf(kRevealed, pixel, texel, path, t);
    if (next == texel || !isInside(next, textureSize(color_tex, 0))) break;
    texel = next;
  }
  return nearest;
}

// Texel where the search with candidate k begins. For straight motion, it is `texel`, the end of the candidate's displacement.
// For a curved path, it is the texel that the curve was read from: Newton's method finds more distant surfaces from there.
ivec2 startAt(int layer, Candidates candidates, int k, ivec2 texel) {
#if HAS_curve
  ivec2 start = candidates.texels[k];
  if (isCurved(candidate(candidates, k)) && hasSurface(layer, start)) return start;
#endif
  return texel;
}

// Nearest surface at the pixel at time t. `background`: search the revealed layer too.
// Each kind of candidate is needed (docs/derivations.md, "Candidate displacements"):
// - Without the taps along the motion, the slower one of two moving surfaces is missed.
// - Without taps on both sides of the pixel, a slower surface that moves against the dominant motion is missed.
// - Without `second`, a surface that moves across the dominant motion is missed.
Nearest sampleAt(ivec2 pixel, Own own, Candidates candidates, bool background, float t) {
  ivec2 size = textureSize(color_tex, 0);
  Nearest nearest = Nearest(kNothing, pixel, 0.0);
  for (int k = 0; k < candidates.count; ++k) {
    Path path = candidate(candidates, k);
    float tolerance_px = candidates.tolerance_px[k];
    vec2 offset = tapOffset(path, t);
    ivec2 texel = pixel + roundSymmetric(offset), start = startAt(kRaster, candidates, k, texel);
    if (!isInside(start, size)) continue;
    nearest = nearerRaster(nearest, own, pixel, start, t, tolerance_px);
    if (!background) continue;
    start = startAt(kRevealed, candidates, k, texel);
    if (isInside(start, size)) nearest = nearerRevealed(nearest, pixel, start, t, tolerance_px);
  }
  return nearest;
}

void run(ivec2 pixel) {
  ivec2 cell = pixel / params.cell_side;
  if (moved_at(cell).x <= 0.5) {
    imageStore(blurred_img, pixel, vec4(vec3(color_at(pixel)), 1));
    return;
  }

  ivec2 tile = pixel / params.tile;
  bool background = background_at(cell).x > 0.5;
  float jitter = jitterOf(pixel);
  Candidates before = candidatesOf(pixel, dominantBefore(tile), jitter, background, false), after = before;
#if HAS_velocity_post
  after = candidatesOf(pixel, dominantAfter(tile), jitter, background, true);
#endif

  Own own = ownOf(pixel);
  vec3 sum = vec3(0);
  ColorRange color_range = emptyColorRange();
  uint fallbacks = 0u;
  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter);
    Nearest nearest = sampleAt(pixel, own, t > 0.0 ? after : before, background, t);
    if (nearest.layer == kNothing) {
      nearest.layer = isRevealed(pixel) ? kRevealed : kRaster;
      fallbacks += 1u;
    }
    vec3 color = nearest.layer == kRaster && nearest.texel == pixel ? own.color : colorOf(nearest.layer, nearest.texel);
    sum += toSum(color);
    color_range = withColor(color_range, color);
  }
  if (fallbacks > 0u) count_fallback(fallbacks);
  // The mean of equal colours is exact, without rounding.
  vec3 mean = isNarrow(color_range, 0.0) ? color_range.low : fromSum(sum / float(params.samples));
  imageStore(blurred_img, pixel, vec4(mean, 1));
}
