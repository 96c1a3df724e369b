// SPDX-License-Identifier: MIT
// Collects candidate displacements of the background per tile: up to eight distinct displacements of the tile and of the tiles
// around, nearest tiles first. A surface hidden behind the tile's pixels may move by one of these displacements.
// In:  `velocities`: xy: longest displacement of each tile; zw: displacement that differs most from xy; px over the exposure
//      `farthest`: view depth of the farthest moving surface in each tile, metres; 0 without motion
//      `max_displacement`: longest displacement in the image, px over the exposure; absent: twice the image's diagonal
// Out: `candidates_0` to `candidates_3`: two displacements each, px over the exposure; kNoVelocity after the last
//      `farthest_around`: greatest value of `farthest` among all tiles in range, metres
// Method: read the tiles in square rings of growing distance, until eight displacements are found or the range ends. Two
//   displacements are distinct if they differ by more than 1 px and by more than a tenth of the longer one. The range is the
//   largest distance that two surfaces can move apart within the exposure: 2 * L * s, px. L is the longest displacement:
//   `limit` * width or, with `limit` = auto, `max_displacement`. s is spreadFactor (lib/blur.glsl): 1 if the exposure lies on
//   one side of the raster time, 1/2 if it is centred.
// Fails: of more than eight displacements, the displacements of the farthest tiles are lost. Among equally far tiles, the
//   displacements of the last tiles in raster order are lost.
#include "mixin/limit.glsl"
#include "lib/velocity_list.glsl"

struct VelocityList {
  vec2 d[kMaxVelocities];
  int count;
};

// Adds the displacement d, unless the list is full or already contains an equal displacement. Two displacements count
// as equal if they differ by at most 1 px, or by at most a tenth of the longer one. Halving or doubling one of these
// two bounds changes the error of the pipeline hybrid_layered by at most 0.01 % on seven scenes.
VelocityList withMotion(VelocityList velocities, vec2 d) {
  for (int i = 0; i < velocities.count; ++i) {
    float same_px = max(1.0, 0.1 * max(lengthOf(velocities.d[i]), lengthOf(d)));
    if (lengthOf(velocities.d[i] - d) <= same_px) return velocities;
  }
  if (velocities.count == kMaxVelocities) return velocities;
  velocities.d[velocities.count] = d;
  velocities.count += 1;
  return velocities;
}

VelocityList withTile(VelocityList velocities, ivec2 tile) {
  if (!isInside(tile, textureSize(velocities_tex, 0))) return velocities;
  vec4 pair = texelFetch(velocities_tex, tile, 0);
  velocities = withMotion(velocities, vec2(pair.x, pair.y));
  return withMotion(velocities, vec2(pair.z, pair.w));
}

// Adds the displacements of the tiles in the square ring at a distance of `ring` tiles around `tile`, in raster order.
VelocityList withRing(VelocityList velocities, ivec2 tile, int ring) {
  for (int y = -ring; y <= ring; ++y) {
    int stride = abs(y) == ring ? 1 : max(2 * ring, 1);
    for (int x = -ring; x <= ring; x += stride) velocities = withTile(velocities, tile + ivec2(x, y));
  }
  return velocities;
}

// View depth of the farthest moving surface in the tiles at most `radius` tiles away, metres; 0 without motion.
float farthestAround(ivec2 tile, int radius, ivec2 size) {
  ivec2 from = max(tile - radius, ivec2(0)), to = min(tile + radius, size - 1);
  float farthest = 0.0;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) farthest = max(farthest, texelFetch(farthest_tex, ivec2(x, y), 0).x);
  }
  return farthest;
}

void run(ivec2 tile) {
  ivec2 size = textureSize(velocities_tex, 0);
  float reach_px = 2.0 * reachPx() * spreadFactor(frame.shutter);
  int radius = min(int(ceil(reach_px / float(params.tile))), max(size.x, size.y));

  VelocityList velocities;
  velocities.count = 0;
  for (int ring = 0; ring <= radius && velocities.count < kMaxVelocities; ++ring)
    velocities = withRing(velocities, tile, ring);
  for (int i = velocities.count; i < kMaxVelocities; ++i) velocities.d[i] = vec2(kNoVelocity);

  imageStore(candidates_0_img, tile, vec4(velocities.d[0], velocities.d[1]));
  imageStore(candidates_1_img, tile, vec4(velocities.d[2], velocities.d[3]));
  imageStore(candidates_2_img, tile, vec4(velocities.d[4], velocities.d[5]));
  imageStore(candidates_3_img, tile, vec4(velocities.d[6], velocities.d[7]));
  imageStore(farthest_around_img, tile, vec4(farthestAround(tile, radius, size)));
}
