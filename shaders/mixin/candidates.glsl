// SPDX-License-Identifier: MIT
// Needs: PARAM_search_taps, PARAM_marks_unresolved, color_tex, dominant_tex, params.limit, params.samples, revealed_color_tex,
//   revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex, velocity_tex, dominant_post_tex, second_post_tex,
//   velocity_post_tex, dominant_curve_tex, dominant_place_tex, revealed_dominant_post_tex, revealed_velocity_post_tex,
//   revealed_dominant_tex, second_tex; may have: PARAM_trajectory, curve_tex, max_displacement_buf, revealed_curve_tex,
//   max_displacement_post_buf, revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Candidate displacements for a composite of layers. The composite uses them to search for the surface at a pixel at a time.
// The candidates are the different displacements of the tile, of the pixel and of taps along the motion.
// layered/layered_composite.glsl has the rules and the reasons.
#ifndef STROBE_CANDIDATES_GLSL
#define STROBE_CANDIDATES_GLSL
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"

const int kMaxCandidates = 4;

// Tolerance for the rounding of a position to a texel, px: sqrt(1/2), rounded up.
const float kNearest = 0.75;

// Candidate displacements, the curves of their paths and the texels that have them. Unused entries have the displacement
// kUnused, which leads to no texel of the image.
struct Candidates {
  vec4 x, y;
#if HAS_curve
  vec4 curves[kMaxCandidates];
  ivec2 texels[kMaxCandidates];
#endif
  vec4 tolerance_px;
  int count;
  bool overflowed;  // a displacement did not fit that differs from all entries by more than 2 px and 14 %
};

const float kUnused = 1e9;

// Tolerance for the match of a surface, px: the length of the displacement within nearly half the time between two samples.
// With exactly half, a surface half-way between two samples would match at both: for example the pixel's own surface, at the
// samples before and after the raster time.
float toleranceOf(vec2 d) { return 0.99 * lengthOf(d) / float(2 * params.samples); }

// True if the surface at the texel `now` at the raster time is at the pixel at time t. The tolerance is kNearest or a larger
// one: where displacements vary over a surface, the nearest match may be almost half-way to the next sample. The larger
// tolerance is the smaller one of `tolerance_px`, which belongs to the candidate, and of the tolerance for the texel's own
// displacement.
bool isThere(ivec2 pixel, ivec2 now, Path path, float t, float tolerance_px) {
  if (!isAt(pixel, now, path, t, max(kNearest, tolerance_px))) return false;
  return isAt(pixel, now, path, t, kNearest) || isAt(pixel, now, path, t, min(tolerance_px, toleranceOf(path.d)));
}

// Path of candidate k.
Path candidate(Candidates candidates, int k) {
#if HAS_curve
  return onCurve(vec2(candidates.x[k], candidates.y[k]), candidates.curves[k]);
#else
  return straight(vec2(candidates.x[k], candidates.y[k]));
#endif
}

// Add a path, unless it differs from a candidate by half a pixel or less. If the list is full and the path differs from all
// candidates by more than 2 px and 14 %, set `overflowed` instead.
Candidates withCandidate(Candidates candidates, Path path, ivec2 texel) {
  vec2 d = path.d;
  vec4 x = candidates.x - d.x, y = candidates.y - d.y;
  vec4 squares = x * x + y * y;
#if HAS_curve
  for (int k = 0; k < kMaxCandidates; ++k) squares[k] += apartSquared(candidates.curves[k], path.curve);
#endif
  float nearest = min(min(squares.x, squares.y), min(squares.z, squares.w));
  if (nearest <= 0.25) return candidates;
  if (candidates.count == kMaxCandidates) {
    candidates.overflowed = candidates.overflowed || nearest > max(4.0, 0.02 * dot(d, d));
    return candidates;
  }
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

// Add the path of the raster layer at a texel. If `background` is true and the revealed layer has a surface there, add the path
// of this surface too. `after`: paths for the times after the raster time.
Candidates withAllLayers(Candidates candidates, ivec2 at, bool background, bool after) {
  for (int layer = kRaster; layer == kRaster || (background && layer <= kRevealed && isRevealed(at)); ++layer)
    candidates = withCandidate(candidates, pathOf(layer, at, after), at);
  return candidates;
}

// True if further taps cannot change the candidates: the list is full, and `overflowed` is already true or has no effect.
bool isFull(Candidates candidates) {
  return candidates.count == kMaxCandidates && (PARAM_marks_unresolved == 0 || candidates.overflowed);
}

// Index of the tap that is k-th nearest to the raster time. If two taps are equally near (the raster time is in the middle of
// the exposure), the earlier tap comes first.
int nearest(int k) {
  if (isCentred(frame.shutter)) return params.samples / 2 + (k % 2 == 0 ? -1 - k / 2 : k / 2) + (params.samples % 2);
  return frame.shutter.x < 0.0 ? params.samples - 1 - k : k;
}

// Displacements of a tile: the longest one, a second one, and the longest one of the revealed layer.
struct Dominant {
  Path longest, second, revealed;
  ivec2 place;  // texel with the longest displacement
};

// Displacements of a tile for the times before the raster time. If motion is not in two segments, they hold for all times.
Dominant dominantBefore(ivec2 tile) {
  Path longest = onCurve(vec2(dominant_at(tile)), dominant_curve_at(tile)), second = straight(vec2(second_at(tile)));
  Dominant dominant = Dominant(longest, second, longest, ivec2(dominant_place_at(tile)));
  if (HAS_revealed_dominant != 0) dominant.revealed = straight(vec2(revealed_dominant_at(tile)));
  return dominant;
}

// Displacements of a tile for the times after the raster time.
Dominant dominantAfter(ivec2 tile) {
  return Dominant(straight(vec2(dominant_post_at(tile))), straight(vec2(second_post_at(tile))),
                  straight(vec2(revealed_dominant_post_at(tile))), kNoTexel);
}

// Add the displacements at the pixel, then at the taps along the tile's longest and second displacement. The list keeps only
// the first displacements that fit. The taps therefore go from the pixel outwards, so that the list is the same if time is
// reversed. One loop serves all taps, because each inlined copy of the loop's body takes long to compile.
Candidates searched(Candidates candidates, ivec2 pixel, Dominant dominant, float jitter, bool background, bool after) {
  ivec2 size = textureSize(color_tex, 0);
  int ways = PARAM_search_taps == 0 ? 1 : lengthOf(dominant.second.d - dominant.longest.d) > 0.5 ? 3 : 2;
  for (int way = 0; way < ways; ++way) {
    bool along = way > 0;
    Path path = dominant.longest;
    if (way == 2) path = dominant.second;
    int taps = along ? params.samples : 1;
    int sides = along && !isCentred(frame.shutter) ? 2 : 1;  // the taps of a centred exposure are on both sides
    for (int k = 0; k < taps && !isFull(candidates); ++k) {
      ivec2 offset = ivec2(0);
      if (along) {
        int i = clamp(nearest(k), 0, params.samples - 1);
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

// Candidates of a pixel. `background`: add displacements of the revealed layer too. `after`: candidates for the times after the
// raster time.
Candidates candidatesOf(ivec2 pixel, Dominant dominant, float jitter, bool background, bool after) {
  Candidates candidates;
  candidates.x = candidates.y = vec4(kUnused);
  candidates.tolerance_px = vec4(0);
  candidates.count = 0;
  candidates.overflowed = false;
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
