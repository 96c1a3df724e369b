// SPDX-License-Identifier: MIT
// Needs: PARAM_harvest, PARAM_leaves_open, color_tex, dominant_tex, params.limit, params.samples, revealed_color_tex,
//   revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex, velocity_tex; may have: PARAM_trajectory,
//   after_dominant_tex, after_second_tex, after_velocity_tex, curve_tex, dominant_curve_tex, dominant_place_tex, reach_tex,
//   revealed_after_dominant_tex, revealed_after_velocity_tex, revealed_curve_tex, revealed_dominant_tex, second_tex.
// The displacements by which a composite of layers looks for what is at a pixel at some time: those of its tile, its own, and
// those met along the way, as far as they differ. composite/layered.glsl says which, and why.
#ifndef STROBE_CANDIDATES_GLSL
#define STROBE_CANDIDATES_GLSL
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"

const int kMaxCandidates = 4;

// The rounding of a place to a texel, px.
const float kNearest = 0.75;

// Displacements, the unused ones out of reach; how their paths are curved, and the texels that they are of.
struct Candidates {
  vec4 x, y;
#if HAS_curve
  vec4 curves[kMaxCandidates];
  ivec2 texels[kMaxCandidates];
#endif
  vec4 tolerance_px;
  int count;
  bool crowded;  // one was left out that none of the others leads to
};

const float kUnused = 1e9;

// How far from where a displacement looks for it something may be: as far as that goes in nearly half the time between two
// samples, px. What is half-way is as near to the next sample: what is at the pixel at the capture would be there at the
// samples beside it.
float toleranceOf(vec2 d) { return 0.99 * lengthOf(d) / float(2 * params.samples); }

// Is what a texel shows at the pixel at time t, as far as nearest texels tell? Where displacements vary over a surface none
// may be nearer than about half-way to the next sample; so far off may be what moves as fast.
bool isThere(ivec2 pixel, ivec2 now, Path path, float t, float tolerance_px) {
  if (!isAt(pixel, now, path, t, max(kNearest, tolerance_px))) return false;
  return isAt(pixel, now, path, t, kNearest) || isAt(pixel, now, path, t, min(tolerance_px, toleranceOf(path.d)));
}

Path candidate(Candidates candidates, int k) {
#if HAS_curve
  return onCurve(vec2(candidates.x[k], candidates.y[k]), candidates.curves[k]);
#else
  return straight(vec2(candidates.x[k], candidates.y[k]));
#endif
}

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
    candidates.crowded = candidates.crowded || nearest > max(4.0, 0.02 * dot(d, d));
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

// Those of all layers at a texel: of what is behind raster, where it holds something.
Candidates withAllLayers(Candidates candidates, ivec2 at, bool behind, bool after) {
  for (int layer = kRaster; layer == kRaster || (behind && layer <= kRevealed && isRevealed(at)); ++layer)
    candidates = withCandidate(candidates, pathOf(layer, at, after), at);
  return candidates;
}

// Is there nothing more to learn from others?
bool isFull(Candidates candidates) {
  return candidates.count == kMaxCandidates && (PARAM_leaves_open == 0 || candidates.crowded);
}

// The k-th nearest of the taps. Of two equally far away, with the capture in the middle, the one before it comes first.
int nearest(int k) {
  if (isCentred(frame.shutter)) return params.samples / 2 + (k % 2 == 0 ? -1 - k / 2 : k / 2) + (params.samples % 2);
  return frame.shutter.x < 0.0 ? params.samples - 1 - k : k;
}

// The displacements of the tile.
struct Dominant {
  Path longest, second, revealed;
  ivec2 place;  // the texel that has the longest
};

ivec2 placeOfDominant(ivec2 tile) {
#if HAS_dominant_place
  return ivec2(texelFetch(dominant_place_tex, tile, 0).xy);
#else
  return kNoTexel;
#endif
}

Dominant dominantBefore(ivec2 tile) {
  Path longest = dominantPath(vec2(texelFetch(dominant_tex, tile, 0)), tile);
  Dominant dominant = Dominant(longest, longest, longest, placeOfDominant(tile));
#if HAS_second
  dominant.second = straight(vec2(texelFetch(second_tex, tile, 0)));
#endif
#if HAS_revealed_dominant
  dominant.revealed = straight(vec2(texelFetch(revealed_dominant_tex, tile, 0)));
#endif
  return dominant;
}

Dominant dominantAfter(ivec2 tile) {
#if HAS_after_dominant
  Path longest = straight(vec2(texelFetch(after_dominant_tex, tile, 0)));
  Dominant dominant = Dominant(longest, longest, longest, kNoTexel);
#if HAS_after_second
  dominant.second = straight(vec2(texelFetch(after_second_tex, tile, 0)));
#endif
#if HAS_revealed_after_dominant
  dominant.revealed = straight(vec2(texelFetch(revealed_after_dominant_tex, tile, 0)));
#endif
  return dominant;
#else
  return dominantBefore(tile);
#endif
}

// Those met at the pixel, then at the taps along the longest and the second of its tile, from the pixel outwards, since only
// the first few count: the same whichever way time runs. In one loop: each copy of what is asked there takes long to compile.
Candidates harvested(Candidates candidates, ivec2 pixel, Dominant dominant, float jitter, bool behind, bool after) {
  ivec2 size = textureSize(color_tex, 0);
  int ways = PARAM_harvest == 0 ? 1 : lengthOf(dominant.second.d - dominant.longest.d) > 0.5 ? 3 : 2;
  for (int way = 0; way < ways; ++way) {
    bool along = way > 0;
    Path path = dominant.longest;
    if (way == 2) path = dominant.second;
    int taps = along ? params.samples : 1;
    int sides = along && !isCentred(frame.shutter) ? 2 : 1;  // centred the taps lie to both sides already
    for (int k = 0; k < taps && !isFull(candidates); ++k) {
      ivec2 offset = ivec2(0);
      if (along) {
        int i = clamp(nearest(k), 0, params.samples - 1);
        offset = roundSymmetric(tapOffset(path, sampleTime(i, params.samples, jitter)));
      }
      for (int side = 0; side < sides; ++side) {
        ivec2 at = side == 0 ? pixel + offset : pixel - offset;
        if (isInside(at, size)) candidates = withAllLayers(candidates, at, behind, after);
      }
    }
  }
  return candidates;
}

Candidates candidatesOf(ivec2 pixel, Dominant dominant, float jitter, bool behind, bool after) {
  Candidates candidates;
  candidates.x = candidates.y = vec4(kUnused);
  candidates.tolerance_px = vec4(0);
  candidates.count = 0;
  candidates.crowded = false;
#if HAS_curve
  for (int k = 0; k < kMaxCandidates; ++k) {
    candidates.curves[k] = vec4(0);
    candidates.texels[k] = kNoTexel;
  }
#endif
  candidates = withCandidate(candidates, dominant.longest, dominant.place);
  candidates = withCandidate(candidates, dominant.second, kNoTexel);
  candidates = withCandidate(candidates, dominant.revealed, kNoTexel);
  return harvested(candidates, pixel, dominant, jitter, behind, after);
}

#endif
