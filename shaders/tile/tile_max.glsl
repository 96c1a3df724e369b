// SPDX-License-Identifier: MIT
// Per tile, the longest displacement in it (McGuire 2012, TileMax), shortened to the limit.
// In:  `velocity`:    px over the exposure
//      `valid`:       above 1/2 where the texel counts; absent: all count
//      `curve`:       curves of the paths, px; absent: straight
//      `extra_velocity`, `extra_valid`, `extra_curve`: velocity, valid and curve of a second layer over the same pixels;
//                     absent: none
// Out: `longest`:     px over the exposure, at most `limit` image widths; 0 if no texel counts
//      `curve_of_it`: curve of its path, px; 0 if paths are straight
//      `place_of_it`: texel that has it, px; 0 if paths are straight
// Method: maximum over the texels of the tile in both layers, by a work group. A curved path is as long as the straight
//      displacement that reaches as far. At equal length the first texel in raster order wins, and of two layers the first.
//      Tiles at the right and bottom border may be partial.
// Fails: one displacement stands for a tile: crossing motions in it are lost.
#include "mixin/path.glsl"
#include "lib/group.glsl"

struct Longest {
  vec2 d;
  vec4 curve;
  ivec2 place;
  float d_length;  // length of the straight displacement that reaches as far, px
  uint layer;
};

uint clamped = 0u;  // texels longer than the limit

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
  // Ties: the first texel in raster order, then the first layer.
  uint place = 2u * placeInTile(longest.place, first, params.tile) + longest.layer;
  if (longest.d_length == 0.0) place = gl_LocalInvocationIndex;
  if (!isGreatest(longest.d_length, place)) return;

  Path path = limitedPath(vec4(longest.d, 0, 0), longest.curve);
  float length_px = max(lengthOf(path.d), reachOf(path));
  atomicMax(max_displacement_buf.entries[0], floatBitsToUint(length_px));  // bits of floats from 0 on are in their order
  imageStore(longest_img, tile, vec4(path.d, 0, 0));
#if HAS_curve
  imageStore(curve_of_it_img, tile, path.curve);
  imageStore(place_of_it_img, tile, vec4(longest.place, 0, 0));
#else
  imageStore(curve_of_it_img, tile, vec4(0));
  imageStore(place_of_it_img, tile, vec4(0));
#endif
}
