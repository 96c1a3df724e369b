// SPDX-License-Identifier: MIT
// Per tile, up to eight distinct displacements of the tiles around it, nearest tiles first: the candidate displacements of the
// background hidden behind its pixels.
// In:  motions: two displacements of each tile, px over the exposure.
//      farthest: view depth of the farthest moving surface in each tile, metres; 0 without motion.
//      reach: longest displacement in the image, px over the exposure, one texel (optional).
// Out: motions_0 .. motions_3: two displacements each, px over the exposure; kNoMotion after the last.
//      farthest_around: greatest `farthest` of all tiles in range, metres.
// Method: tiles are searched ring by ring, as far as two surfaces can part within the exposure: twice the longest displacement
//   (limit * width, or reach), times reachFactor. Two displacements are distinct if they differ by more than 1 px and by more
//   than a tenth of the longer one.
// Fails: if there are more than eight displacements the far ones are lost, at equal distance the last ones in raster order.
#include "mixin/limit.glsl"
#include "lib/motions.glsl"

struct Motions {
  vec2 d[kMaxMotions];
  int count;
};

Motions withMotion(Motions motions, vec2 d) {
  for (int i = 0; i < motions.count; ++i) {
    float same_px = max(1.0, 0.1 * max(lengthOf(motions.d[i]), lengthOf(d)));
    if (lengthOf(motions.d[i] - d) <= same_px) return motions;
  }
  if (motions.count == kMaxMotions) return motions;
  motions.d[motions.count] = d;
  motions.count += 1;
  return motions;
}

Motions withTile(Motions motions, ivec2 tile) {
  if (!isInside(tile, textureSize(motions_tex, 0))) return motions;
  vec4 pair = texelFetch(motions_tex, tile, 0);
  motions = withMotion(motions, vec2(pair.x, pair.y));
  return withMotion(motions, vec2(pair.z, pair.w));
}

// Adds the tiles at the distance `ring`, in raster order.
Motions withRing(Motions motions, ivec2 tile, int ring) {
  for (int y = -ring; y <= ring; ++y) {
    int stride = abs(y) == ring ? 1 : max(2 * ring, 1);
    for (int x = -ring; x <= ring; x += stride) motions = withTile(motions, tile + ivec2(x, y));
  }
  return motions;
}

float farthestAround(ivec2 tile, int radius, ivec2 size) {
  ivec2 from = max(tile - radius, ivec2(0)), to = min(tile + radius, size - 1);
  float farthest = 0.0;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) farthest = max(farthest, texelFetch(farthest_tex, ivec2(x, y), 0).x);
  }
  return farthest;
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(motions_tex, 0);
  float reach_px = 2.0 * reachPx() * reachFactor(frame.shutter);
  int radius = min(int(ceil(reach_px / float(params.tile))), max(size.x, size.y));

  Motions motions;
  motions.count = 0;
  for (int ring = 0; ring <= radius && motions.count < kMaxMotions; ++ring) motions = withRing(motions, pixel, ring);
  for (int i = motions.count; i < kMaxMotions; ++i) motions.d[i] = vec2(kNoMotion);

  imageStore(motions_0_img, pixel, vec4(motions.d[0], motions.d[1]));
  imageStore(motions_1_img, pixel, vec4(motions.d[2], motions.d[3]));
  imageStore(motions_2_img, pixel, vec4(motions.d[4], motions.d[5]));
  imageStore(motions_3_img, pixel, vec4(motions.d[6], motions.d[7]));
  imageStore(farthest_around_img, pixel, vec4(farthestAround(pixel, radius, size)));
}
