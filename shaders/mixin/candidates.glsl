// SPDX-License-Identifier: MIT
// Needs: PARAM_search_taps, color_tex, dominant_tex, params.limit, params.samples, revealed_color_tex,
//   revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex, velocity_tex, dominant_post_tex, second_post_tex,
//   velocity_post_tex, dominant_curve_tex, dominant_place_tex, revealed_dominant_post_tex, revealed_velocity_post_tex,
//   revealed_dominant_tex, second_tex; may have: PARAM_trajectory, curve_tex, max_displacement_buf, revealed_curve_tex,
//   max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Candidate displacements of a pixel, for the composite of layers (layered/layered_composite.glsl, with the rules and the
// reasons). For each time sample, the composite follows each candidate from the pixel back to a texel of the raster time. It
// then tests if the texel's surface is at the pixel at the time of the sample. The candidates are the displacements of the
// tile, of the pixel and of taps along the motion. At most four candidates are kept, and they all differ.
#ifndef STROBE_CANDIDATES_GLSL
#define STROBE_CANDIDATES_GLSL
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"

// Largest number of candidates of a pixel. Four displacements fill the components of a vec4, so that one comparison of vectors
// finds a candidate that is nearly equal to a new one.
const int kMaxCandidates = 4;

// Least tolerance for the match of a surface, px. Rounding a position to a texel moves the position by up to sqrt(1/2) px; the
// tolerance is this value, rounded up.
const float kNearest = 0.75;

// List of candidates. The entries from `count` on are unused. Their displacement is kUnused, which differs from every real
// displacement, so that `withCandidate` can compare a path with all entries.
struct Candidates {
  vec4 x, y;  // displacements (x[k], y[k]), px over the exposure
#if HAS_curve
  vec4 curves[kMaxCandidates];   // curves of the paths (mixin/curve.glsl)
  ivec2 texels[kMaxCandidates];  // texels that have these paths; kNoTexel: unknown
#endif
  vec4 tolerance_px;  // result of toleranceOf for each displacement, px
  int count;          // 0 to kMaxCandidates
};

// Component of the displacement of an unused entry, px.
const float kUnused = 1e9;

// Tolerance for the match of a surface with the displacement d, px: the distance that the surface moves in nearly half the time
// between two samples. With exactly half, a surface half-way between two samples would match at both samples. The pixel's own
// surface is an example, at the samples before and after the raster time.
float toleranceOf(vec2 d) { return 0.99 * lengthOf(d) / float(2 * params.samples); }

// True if the surface that `texel` shows at the raster time is at the pixel at time t, within
// max(kNearest, min(tolerance_px, toleranceOf(path.d))) px. `path`: path of this surface. `tolerance_px`: tolerance of
// the candidate that led to the texel. Tolerances above kNearest serve surfaces whose displacement varies from texel to
// texel: even the best texel may then miss the pixel by nearly half the distance that the surface moves between two
// samples.
bool isThere(ivec2 pixel, ivec2 texel, Path path, float t, float tolerance_px) {
  if (!isAt(pixel, texel, path, t, max(kNearest, tolerance_px))) return false;
  return isAt(pixel, texel, path, t, kNearest) || isAt(pixel, texel, path, t, min(tolerance_px, toleranceOf(path.d)));
}

// Path of candidate k, 0 <= k < candidates.count.
Path candidate(Candidates candidates, int k) {
#if HAS_curve
  return onCurve(vec2(candidates.x[k], candidates.y[k]), candidates.curves[k]);
#else
  return straight(vec2(candidates.x[k], candidates.y[k]));
#endif
}

// True if no further candidate fits.
bool isFull(Candidates candidates) { return candidates.count == kMaxCandidates; }

// Candidates with one more path. `texel`: texel that has the path; kNoTexel if unknown. The path is not added if it differs
// from a candidate by half a pixel or less, or if the list is full.
Candidates withCandidate(Candidates candidates, Path path, ivec2 texel) {
  if (isFull(candidates)) return candidates;
  vec2 d = path.d;
  vec4 x = candidates.x - d.x, y = candidates.y - d.y;
  vec4 squares = x * x + y * y;
#if HAS_curve
  for (int k = 0; k < kMaxCandidates; ++k) squares[k] += apartSquared(candidates.curves[k], path.curve);
#endif
  float nearest = min(min(squares.x, squares.y), min(squares.z, squares.w));
  if (nearest <= 0.25) return candidates;
  candidates.x[candidates.count] = d.x;
  candidates.y[candidates.count] = d.y;
#if HAS_curve
  candidates.curves[candidates.count] = path.curve;
  candidates.texels[candidates.count] = texel;
#endif
  candidates.tolerance_px[candidates.count] = toleranceOf(d);
  candidates.count += 1;
  return candidates;
}

// Candidates with the path of the raster layer at the texel `at`. If `background` is true and the revealed layer has a surface
// at this texel, the path of that surface is added too. `after`: add paths for the times after the raster time; otherwise paths
// for the times before.
Candidates withAllLayers(Candidates candidates, ivec2 at, bool background, bool after) {
  for (int layer = kRaster; layer == kRaster || (background && layer <= kRevealed && isRevealed(at)); ++layer)
    candidates = withCandidate(candidates, pathOf(layer, at, after), at);
  return candidates;
}

// Index of the time sample that is k-th nearest to the raster time, k from 0. A centred exposure has pairs of equally near
// samples. In a pair, the earlier sample comes first if the number of samples is even; the later one comes first if it is odd.
int nearestSample(int k) {
  if (isCentred(frame.shutter)) return params.samples / 2 + (k % 2 == 0 ? -1 - k / 2 : k / 2) + (params.samples % 2);
  return frame.shutter.x < 0.0 ? params.samples - 1 - k : k;
}

// Displacements of a tile: the longest one, a different second one, and the longest one of the revealed layer.
struct Dominant {
  Path longest, second, revealed;
  ivec2 place;  // texel that has the longest displacement; kNoTexel: unknown
};

// Displacements of a tile for the times before the raster time. Unless motion is in two segments, they are valid for
// all times. Without the image `revealed_dominant`, the longest displacement of the raster layer also stands for the
// revealed layer.
Dominant dominantBefore(ivec2 tile) {
  Path longest = onCurve(vec2(dominant_at(tile)), dominant_curve_at(tile)), second = straight(vec2(second_at(tile)));
  Dominant dominant = Dominant(longest, second, longest, ivec2(dominant_place_at(tile)));
  if (HAS_revealed_dominant != 0) dominant.revealed = straight(vec2(revealed_dominant_at(tile)));
  return dominant;
}

// Displacements of a tile for the times after the raster time, if motion is in two segments.
Dominant dominantAfter(ivec2 tile) {
  return Dominant(straight(vec2(dominant_post_at(tile))), straight(vec2(second_post_at(tile))),
                  straight(vec2(revealed_dominant_post_at(tile))), kNoTexel);
}

// Candidates with the displacements at the pixel and, with `search_taps`, at the taps along the tile's longest displacement and
// then along its second displacement. `jitter`: shift of the tap times, as a share of the time between two samples.
// `background`, `after`: as in `withAllLayers`. The list keeps the first displacements that fit. The taps go from the pixel
// outwards, so that with the anchors `end` and `start` a reversal of time does not change the order. One loop serves all taps,
// because each inlined copy of the loop's body takes long to compile.
Candidates searched(Candidates candidates, ivec2 pixel, Dominant dominant, float jitter, bool background, bool after) {
  ivec2 size = textureSize(color_tex, 0);
  int ways = PARAM_search_taps == 0 ? 1 : lengthOf(dominant.second.d - dominant.longest.d) > 0.5 ? 3 : 2;
  // Way 0 reads the pixel itself, way 1 the taps along the longest displacement, way 2 the taps along the second one.
  for (int way = 0; way < ways; ++way) {
    bool along = way > 0;
    Path path = dominant.longest;
    if (way == 2) path = dominant.second;
    int taps = along ? params.samples : 1;
    // Read taps on both sides of the pixel, because a surface that moves against the dominant displacement comes from the other
    // side. With a centred exposure, the sample times already place taps on both sides, so no further taps are needed.
    int sides = along && !isCentred(frame.shutter) ? 2 : 1;
    for (int k = 0; k < taps && !isFull(candidates); ++k) {
      ivec2 offset = ivec2(0);
      if (along) {
        int i = clamp(nearestSample(k), 0, params.samples - 1);
        offset = roundSymmetric(tapOffset(path, sampleTime(i, params.samples, jitter)));
      }
      for (int side = 0; side < sides; ++side) {
        ivec2 at = side == 0 ? pixel + offset : pixel - offset;
        if (isInside(at, size)) candidates = withAllLayers(candidates, at, background, after);
      }
    }
  }
  return candidates;
}

// Candidates of a pixel: the displacements of the tile (`dominant`), then the displacements at the pixel and at its taps.
// `jitter`: shift of the tap times, as a share of the time between two samples. `background`: include displacements of the
// revealed layer. `after`: candidates for the times after the raster time; otherwise for the times before.
Candidates candidatesOf(ivec2 pixel, Dominant dominant, float jitter, bool background, bool after) {
  Candidates candidates;
  candidates.x = candidates.y = vec4(kUnused);
  candidates.tolerance_px = vec4(0);
  candidates.count = 0;
#if HAS_curve
  for (int k = 0; k < kMaxCandidates; ++k) {
    candidates.curves[k] = vec4(0);
    candidates.texels[k] = kNoTexel;
  }
#endif
  candidates = withCandidate(candidates, dominant.longest, dominant.place);
  candidates = withCandidate(candidates, dominant.second, kNoTexel);
  candidates = withCandidate(candidates, dominant.revealed, kNoTexel);
  return searched(candidates, pixel, dominant, jitter, background, after);
}

#endif
