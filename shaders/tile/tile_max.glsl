// SPDX-License-Identifier: MIT
// Per tile, the longest displacement of its texels, shortened to the displacement limit (TileMax of McGuire et al. 2012).
// In:  `velocity`: displacement of the surface at each texel, px over the exposure.
//      `valid`: mask, above 1/2 at texels to include (absent: all texels).
//      `curve`: coefficients of the parabola or arc that each texel's path follows (mixin/curve.glsl; absent: paths are
//        straight).
//      `extra_velocity`, `extra_valid`, `extra_curve`: displacement, mask and curve of a second layer over the same pixels
//        (absent: there is one layer).
// Out: `longest`: longest displacement, px over the exposure, at most `limit` image widths long; 0 if no texel is included.
//      `curve_of_it`: curve of the path of `longest`; 0 if paths are straight.
//      `place_of_it`: position of the texel with the displacement `longest`, px; 0 if paths are straight.
//      `max_displacement`: entry 0: length of the longest displacement of the whole image, px over the exposure, as the bits of
//        a float.
// Method: one work group takes the maximum over the tile's texels of both layers. The length of a curved path is the length of
//   a straight displacement that moves a surface at least as far. Of equally long displacements the first in raster order wins,
//   then the first layer. Tiles at the right and bottom border may be partial.
// Fails: one displacement represents a tile. If motions cross in a tile, all but the longest are lost.
#include "mixin/path.glsl"
#include "lib/group.glsl"

struct Longest {
  vec2 d;
  vec4 curve;
  ivec2 place;
  float d_length;  // length of a straight displacement that moves a surface at least as far, px
  uint layer;
};

uint clamped = 0u;  // number of texels with a displacement longer than the limit

// The longer of the longest path so far and the path of one more texel. Counts displacements longer than the limit.
Longest longestOf(Longest so_far, vec2 d, vec4 curve, ivec2 place, uint layer, float limit_px) {
  float d_length = lengthOf(d);
  clamped += d_length > limit_px ? 1u : 0u;
  if (curve != vec4(0)) d_length = reachOf(d, curve, frame.shutter);
  if (d_length > so_far.d_length) return Longest(d, curve, place, d_length, layer);
  return so_far;
}

void run(ivec2 tile) {
  ivec2 size = textureSize(velocity_tex, 0);
  ivec2 first = tile * params.tile;
  ivec2 end = min(first + params.tile, size);
  float limit_px = limitPx();

  Longest longest = Longest(vec2(0), vec4(0), ivec2(0), 0.0, 0u);
  ivec2 own = ownFirst(first);
  for (int y = own.y; y < end.y; y += kGroupSide) {
    for (int x = own.x; x < end.x; x += kGroupSide) {
      ivec2 p = ivec2(x, y);
      if (valid_at(p).x > 0.5) {
        longest = longestOf(longest, finiteDisplacement(velocity_at(p)), curve_at(p), p, 0u, limit_px);
      }
#if HAS_extra_velocity
      if (extra_valid_at(p).x > 0.5) {
        longest = longestOf(longest, finiteDisplacement(extra_velocity_at(p)), extra_curve_at(p), p, 1u, limit_px);
      }
#endif
    }
  }
  if (clamped > 0u) count_clamped(clamped);
  // Among equally long displacements, the texel with the least number wins: the first texel in raster order, then the first
  // layer. If the tile has no motion, the first invocation writes the result.
  uint place = 2u * placeInTile(longest.place, first, params.tile) + longest.layer;
  if (longest.d_length == 0.0) place = gl_LocalInvocationIndex;
  if (!isGreatest(longest.d_length, place)) return;

  Path path = limitedPath(vec4(longest.d, 0, 0), longest.curve);
  float length_px = max(lengthOf(path.d), reachOf(path));
  // Floats of at least 0 have the order of their bits, so that an atomic maximum of the bits is the maximum of the floats.
  atomicMax(max_displacement_buf.entries[0], floatBitsToUint(length_px));
  imageStore(longest_img, tile, vec4(path.d, 0, 0));
#if HAS_curve
  imageStore(curve_of_it_img, tile, path.curve);
  imageStore(place_of_it_img, tile, vec4(longest.place, 0, 0));
#else
  imageStore(curve_of_it_img, tile, vec4(0));
  imageStore(place_of_it_img, tile, vec4(0));
#endif
}
