// SPDX-License-Identifier: MIT
// Disocclusion mask by relative motion: marks pixels that hide a surface which becomes visible within the exposure (an
// extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Layers").
// In:  `depth`: view depth, metres; +inf for the sky
//      `id`: instance + 1; 0 for the sky
//      `velocity`: displacement of each pixel, px over the exposure
//      `culled_0` to `culled_3`: per cell, candidate displacements of the background, two per image; kNoVelocity after the last
//      `bounds`, `ids`: per cell, bounds of the displacements; least and greatest instance + 1
//      `farthest_around`: depth of the farthest moving surface around each tile, metres; static pixels beyond this
//        depth are skipped
//      `max_displacement`: longest displacement in the image, px over the exposure; absent: twice the image's diagonal
// Out: `mask`: 1 where the pass ray_reveal is to trace a ray to the background, otherwise 0
// Method: let the foreground at pixel y move by d, and a point hidden behind y by the candidate b. At time t, the point
//   is at y + b*t. The foreground covers this place with its texel y - t*(d - b) of the raster time. The point becomes
//   visible once this texel is beyond the silhouette of the foreground. Only the relative motion d - b counts: a
//   foreground that a tracking shot keeps static on the screen is marked too.
//   1. Path: y - t*(d - b) from the raster time to shutter open or close, and `margin` px farther: an extra pixel costs
//      a ray, a missing pixel is an error. Paths end at the image border (counter `off_screen`).
//   2. Walk: follow the path in steps of 1 px. Mark y if the walk meets a pixel q of another instance that moves by b,
//      within max(1 px, match * |d - b|) (parameter `match`).
//   3. Occluders: skip each q that is nearer than the last pixel of y's instance by the share `occluder`. If the path
//      ends on an occluder, continue the walk to the first pixel beyond the occluder.
//   4. Second walk: if no q moves by b, walk again, with the displacement of the first q that moves relative to y in
//      place of b, because candidates are inexact where the motion of a background varies.
// Fails: misses backgrounds if no pixel around shows their motion, parts of an instance behind other parts of the instance, and
//   motions beyond the eighth near a tile.
#include "lib/bounds.glsl"
#include "lib/velocity_list.glsl"
#include "lib/sanitise.glsl"
#include "mixin/limit.glsl"

// A walk runs three loops with small bodies, one after the other (firstPossibleEnd, lastOwn, walked). The reason is that a GPU
// runs a loop until the slowest pixel of a subgroup has finished the loop, and the other pixels wait.

// Path y - t*(d - b) of a walk from the pixel y, in steps of one pixel.
struct Path {
  ivec2 pixel;        // y
  vec2 d, b;          // displacements of the foreground at y and of the background, px over the exposure
  float t;            // time at the end of the path, in exposures from the raster time
  vec2 unit;          // offset of one step, px
  int steps;          // steps to the end of the path, `margin` included
  int longest;        // largest number of steps, if the walk continues beyond an occluder at the end of the path
  int inside;         // number of steps until the path leaves the image
  uint own;           // instance + 1 at y
  float matching_px;  // displacements at most this far from b count as equal to b, px
};

const int kNoStep = 1 << 24;

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

// Path of `pixel`, which moves by `d`, relative to a background with the candidate displacement `b`, until time t. Requires
// isPath(d, b, t): the path is at least half a pixel long.
Path pathOf(ivec2 pixel, uint own, vec2 d, vec2 b, float t) {
  vec2 whole = tapOffset(d - b, t);
  float whole_px = lengthOf(whole);
  vec2 unit = whole / whole_px;
  int steps = int(ceil(whole_px)) + params.margin;
  vec2 room = mix(vec2(pixel), vec2(textureSize(id_tex, 0) - 1 - pixel), greaterThan(unit, vec2(0))) + 0.5;
  vec2 inside = room / max(abs(unit), vec2(1e-6)) - 1e-3;
  return Path(pixel, d, b, t, unit, steps, steps + int(ceil(reachPx())),
              int(min(min(inside.x, inside.y), float(kNoStep))), own, max(1.0, params.match * lengthOf(d - b)));
}

bool isPath(vec2 d, vec2 b, float t) { return lengthOf(tapOffset(d - b, t)) >= 0.5; }

ivec2 placeOn(Path path, int i) { return path.pixel + roundSymmetric(path.unit * float(i)); }

bool isOwn(Path path, ivec2 at) { return texelFetch(id_tex, at, 0).x == path.own; }

float depthAt(ivec2 at) { return saneDepth(texelFetch(depth_tex, at, 0).x); }

// True if a surface at `depth` is an occluder of a foreground at `own_depth`: nearer by more than the share `occluder`. The
// foreground may continue behind an occluder. The parameter `occluder` must be large enough for a slanted background, such as
// the ground under an object. Such a background can be slightly nearer at the end of the path, although it is farther at the
// pixel itself.
bool occludes(float depth, float own_depth) { return depth < own_depth * (1.0 - params.occluder); }

// True if a walk along the path may end in the cell, or if the cell may show the displacement that a second walk needs.
// In the first case, the cell may show another instance that moves by about b. In the second case, it may show another
// instance that moves relative to the foreground at y.
bool mayEndIn(Path path, ivec2 cell) {
  uvec2 ids = uvec2(texelFetch(ids_tex, cell, 0));
  vec4 bounds = texelFetch(bounds_tex, cell, 0);
  const float slack = 1.0 + 1e-4;
  bool matches = shortestIn(relativeTo(bounds, path.b)) <= path.matching_px * slack;
  bool moves = abs(path.t) * longestIn(relativeTo(bounds, path.d)) * slack >= 0.5;
  return (matches || moves) && !(ids.x == path.own && ids.y == path.own);
}

// First step of the path, from `from` to `to`, that lies in a cell where the walk may end (`mayEndIn`), or a step shortly
// before; kNoStep without such a cell. The search goes from cell to cell along the path (Amanatides and Woo, "A Fast Voxel
// Traversal Algorithm", 1987).
int firstPossibleEnd(Path path, int from, int to) {
  ivec2 cell = placeOn(path, from) / params.cell_side;
  ivec2 ahead = ivec2(greaterThan(path.unit, vec2(0)));
  vec2 inverse = 1.0 / max(abs(path.unit), vec2(1e-6));
  vec2 border = abs(vec2((cell + ahead) * params.cell_side) - (vec2(path.pixel) + 0.5));
  vec2 next = border * inverse, per_cell = float(params.cell_side) * inverse;  // in steps
  float entered = float(from);
  while (entered <= float(to) && !mayEndIn(path, cell)) {
    entered = min(next.x, next.y);
    bvec2 crossed = equal(next, vec2(entered));
    cell += ivec2(crossed) * (2 * ahead - 1);
    next += vec2(crossed) * per_cell;
  }
  return entered > float(to) ? kNoStep : max(from, int(entered));
}

struct Walk {
  bool crosses;   // the path meets a background that moves by b
  bool meets;     // the path meets a background that moves relative to the foreground at y, but not by b
  vec2 d_beyond;  // displacement of the first such background, px over the exposure; valid only if `meets` is true
};

// Last step, before step i, where the path is on the instance of the pixel y; step 0 is y itself.
int lastOwn(Path path, int i) {
  --i;
  while (i > 0 && !isOwn(path, placeOn(path, i))) --i;
  return i;
}

Walk walked(Path path) {
  Walk walk = Walk(false, false, vec2(0));
  int first = firstPossibleEnd(path, 1, path.longest);
  if (first == kNoStep) return walk;
  // If the path ends on an occluder, continue to the first pixel beyond the occluder: the occluder may hide the
  // silhouette of the foreground, which is the surface at y.
  int i = min(first, path.steps);
  int own_step = lastOwn(path, i);
  bool occluded = false;
  for (; i <= path.steps || (occluded && i <= path.longest); ++i) {
    if (i > path.inside) break;
    ivec2 at = placeOn(path, i);
    if (isOwn(path, at)) {
      if (i > path.steps) break;
      own_step = i;
      occluded = false;
      continue;
    }
    occluded = occludes(depthAt(at), depthAt(placeOn(path, own_step)));
    if (occluded) continue;
    vec2 d_beyond = displacementAt(at);
    walk.crosses = lengthOf(d_beyond - path.b) <= path.matching_px;
    if (walk.crosses) break;
    if (walk.meets || !isPath(path.d, d_beyond, path.t)) continue;
    walk.meets = true;
    walk.d_beyond = d_beyond;
  }
  return walk;
}

// True if a point that moves by b behind the foreground of the pixel, which moves by d, becomes visible between the raster time
// and time t.
bool disoccludes(ivec2 pixel, uint own, vec2 d, vec2 b, float t) {
  Walk walk = Walk(false, true, b);
  bool off_screen = false;
  for (int attempt = 0; attempt < 2 && walk.meets && !walk.crosses && isPath(d, walk.d_beyond, t); ++attempt) {
    Path path = pathOf(pixel, own, d, walk.d_beyond, t);
    walk = walked(path);
    off_screen = path.inside < path.steps;
  }
  if (off_screen && !walk.crosses) count_off_screen(1u);
  return walk.crosses;
}

// True if the pixel is static and farther than each moving surface around. Such a pixel is background: it hides no moving
// surface that the image shows, so nothing becomes visible behind it.
bool isStaticBackground(ivec2 pixel, vec2 d) {
  return d == vec2(0) && occludes(texelFetch(farthest_around_tex, pixel / params.tile, 0).x, depthAt(pixel));
}

void run(ivec2 pixel) {
  ivec2 cell = pixel / params.cell_side;
  vec4 pair = texelFetch(culled_0_tex, cell, 0);
  bool mask = false;
  uint own = texelFetch(id_tex, pixel, 0).x;
  vec2 d = displacementAt(pixel);
  if (isVelocity(vec2(pair.x, pair.y)) && own != 0u && !isStaticBackground(pixel, d)) {
    vec4 pairs[4] = vec4[4](pair, texelFetch(culled_1_tex, cell, 0), texelFetch(culled_2_tex, cell, 0),
                            texelFetch(culled_3_tex, cell, 0));
    for (int k = 0; k < 2 * kMaxVelocities && !mask; ++k) {
      vec2 b = (k & 2) == 0 ? pairs[k / 4].xy : pairs[k / 4].zw;
      float t = (k & 1) == 0 ? frame.shutter.x : frame.shutter.y;
      if (!isVelocity(b)) break;
      mask = t != 0.0 && disoccludes(pixel, own, d, b, t);
    }
  }
  imageStore(mask_img, pixel, vec4(mask ? 1 : 0));
}
