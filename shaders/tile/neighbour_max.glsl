// SPDX-License-Identifier: MIT
// Per tile, the longest displacement of the tiles around it that can matter (McGuire 2012, NeighborMax).
// In:  longest (px over the exposure, per tile).  Out: dominant (px over the exposure, per tile).
// Tiles up to ceil(limit * width * reach / tile) away are asked, reach = 1 one-sided, 1/2 centred. Rule `all` accepts every
// one of them. Rule `reach` accepts a tile only if its box, swept along its own vector over the exposure window, overlaps
// this tile: for vectors no longer than a tile that is the sign rule of Guertin et al. 2014 (off-axis tiles count only if
// they move towards this one), for either anchor and any distance. Of equal lengths the first in raster order wins.
// Fails: a tile is judged by its longest vector; a slower pixel in it that comes this way while the longest does not is
// lost.
#include "lib/blur.glsl"

// Open interval of times at which a tile `offset` tiles away that moves by d (px along one axis) overlaps this tile along
// that axis: |offset * tile + d * t| < tile.
vec2 overlapTimes(int offset, float d, float tile_px) {
  if (d == 0.0) return offset == 0 ? vec2(-1e30, 1e30) : vec2(1.0, -1.0);
  float a = (-tile_px - float(offset) * tile_px) / d;
  float b = (tile_px - float(offset) * tile_px) / d;
  return vec2(min(a, b), max(a, b));
}

bool reaches(ivec2 offset, vec2 d) {
  vec2 in_x = overlapTimes(offset.x, d.x, float(params.tile));
  vec2 in_y = overlapTimes(offset.y, d.y, float(params.tile));
  float first = max(in_x.x, in_y.x);
  float last = min(in_x.y, in_y.y);
  return first < last && first < frame.shutter.y && last > frame.shutter.x;
}

bool accepts(ivec2 offset, vec2 d) {
#if PARAM_rule == rule_reach
  return reaches(offset, d);
#else
  return true;
#endif
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(longest_tex, 0);
  float reach_px = params.limit * float(frame.size.x) * reachFactor(frame.shutter);
  int radius = min(int(ceil(reach_px / float(params.tile))), max(size.x, size.y));
  ivec2 first = max(pixel - radius, ivec2(0));
  ivec2 last = min(pixel + radius, size - 1);

  vec2 dominant = vec2(0);
  float dominant_length = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      vec2 d = vec2(texelFetch(longest_tex, ivec2(x, y), 0));
      float d_length = lengthOf(d);
      if (d_length <= dominant_length || !accepts(ivec2(x, y) - pixel, d)) continue;
      dominant = d;
      dominant_length = d_length;
    }
  }
  imageStore(dominant_img, pixel, vec4(dominant, 0, 0));
}
