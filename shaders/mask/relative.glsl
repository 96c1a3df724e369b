// SPDX-License-Identifier: MIT
// The pixels behind which something hidden at the capture becomes visible within the exposure.
//
// A point hidden behind pixel y moves by b, the foreground at y by d: at time t the point is at y + b*t, where the
// foreground shows what is now at y + b*t - d*t = y - t*(d - b). So it is seen if the path y - t*(d - b) leaves the
// foreground within the window: motion relative to the background decides, not motion, and a foreground at rest has its
// mask where the background moves (a tracking shot).
//
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), velocity (px over the exposure);
//      crossing_0 .. crossing_3: displacements found around each cell, the candidates for b (kNoMotion after the last).
//      bounds, ids: the displacements and instances of each cell, so that walks pass over cells which cannot matter;
//      farthest_around: view depth of the farthest that moves around each tile. What is at rest on the screen and farther
//      away than that hides nothing which moves.
// Out: mask, 1 if for one candidate b the path meets a pixel q of another instance, not nearer (by `occluder`) than the
//   last pixel of y's own instance met, that does move by about b (within a pixel, or match * |d - b|). If the first q
//   that moves relative to y moves otherwise, the path is walked once more with q's own displacement for b. Candidates
//   are rough where a background's motion varies; q's is exact. A path that ends behind an occluder goes on to where that
//   ends. One step per pixel of the path, plus `margin` px: an overmarked pixel costs a ray, a missed one an error. Paths
//   that leave the picture end there: nobody knows what is outside (counter off_screen).
// Fails: background whose motion is visible nowhere near; self-occlusion of one instance; more than eight movements.
#include "lib/bounds.glsl"
#include "lib/motions.glsl"
#include "lib/sanitise.glsl"
#include "mixin/limit.glsl"

// Loops stand side by side and hold little: processors run a loop for the slowest of several pixels at once.

// A path y - t*(d - b), a step per pixel of it.
struct Path {
  ivec2 pixel;  // y
  vec2 d, b;
  float t;
  vec2 unit;    // of a step
  int steps;    // to its end, with the margin
  int longest;  // if it goes on behind an occluder
  int inside;   // those within the picture
  uint own;     // instance at y
  float matching_px;
};

const int kNoStep = 1 << 24;

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

// From -(d - b) * t, which is half a pixel long at least.
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

// Is what has this depth an occluder, behind which the foreground may go on? A background that slants, as the ground an
// object stands on, is nearer by a little where the path ends, though it is farther at the pixel itself.
bool occludes(float depth, float own_depth) { return depth < own_depth * (1.0 - params.occluder); }

// Can anything in a cell end a walk: another instance that moves by about b, or relative to y?
bool concerns(Path path, ivec2 cell) {
  uvec2 ids = uvec2(texelFetch(ids_tex, cell, 0));
  vec4 bounds = texelFetch(bounds_tex, cell, 0);
  const float slack = 1.0 + 1e-4;
  bool matches = shortestIn(relativeTo(bounds, path.b)) <= path.matching_px * slack;
  bool moves = abs(path.t) * longestIn(relativeTo(bounds, path.d)) * slack >= 0.5;
  return (matches || moves) && !(ids.x == path.own && ids.y == path.own);
}

// The first step from `from` to `to`, or one shortly before it, at which the path is in a cell that can end the walk; or
// kNoStep. Goes along the path from cell to cell (Amanatides and Woo, "A Fast Voxel Traversal Algorithm", 1987).
int firstConcern(Path path, int from, int to) {
  ivec2 cell = placeOn(path, from) / params.cell_side;
  ivec2 ahead = ivec2(greaterThan(path.unit, vec2(0)));
  vec2 inverse = 1.0 / max(abs(path.unit), vec2(1e-6));
  vec2 border = abs(vec2((cell + ahead) * params.cell_side) - (vec2(path.pixel) + 0.5));
  vec2 next = border * inverse, per_cell = float(params.cell_side) * inverse;  // in steps
  float entered = float(from);
  while (entered <= float(to) && !concerns(path, cell)) {
    entered = min(next.x, next.y);
    bvec2 crossed = equal(next, vec2(entered));
    cell += ivec2(crossed) * (2 * ahead - 1);
    next += vec2(crossed) * per_cell;
  }
  return entered > float(to) ? kNoStep : max(from, int(entered));
}

struct Walk {
  bool crosses;   // a silhouette beyond which things move as supposed
  bool meets;     // one beyond which they move otherwise, relative to y
  vec2 d_beyond;  // displacement beyond the first of these
};

// The last of y's own instance before a step.
int lastOwn(Path path, int i) {
  --i;
  while (i > 0 && !isOwn(path, placeOn(path, i))) --i;
  return i;
}

Walk walked(Path path) {
  Walk walk = Walk(false, false, vec2(0));
  int first = firstConcern(path, 1, path.longest);
  if (first == kNoStep) return walk;
  // Behind what stands in front at the end the silhouette may end unseen: on to where that ends.
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

bool uncovers(ivec2 pixel, uint own, vec2 d, vec2 b, float t) {
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

// Is it at rest on the screen, and everything that moves in front of it?
bool isBehindMotion(ivec2 pixel, vec2 d) {
  return d == vec2(0) && occludes(texelFetch(farthest_around_tex, pixel / params.tile, 0).x, depthAt(pixel));
}

void run(ivec2 pixel) {
  ivec2 cell = pixel / params.cell_side;
  vec4 pair = texelFetch(crossing_0_tex, cell, 0);
  bool mask = false;
  uint own = texelFetch(id_tex, pixel, 0).x;
  vec2 d = displacementAt(pixel);
  if (isMotion(vec2(pair.x, pair.y)) && own != 0u && !isBehindMotion(pixel, d)) {
    vec4 pairs[4] = vec4[4](pair, texelFetch(crossing_1_tex, cell, 0), texelFetch(crossing_2_tex, cell, 0),
                            texelFetch(crossing_3_tex, cell, 0));
    for (int k = 0; k < 2 * kMaxMotions && !mask; ++k) {
      vec2 b = (k & 2) == 0 ? pairs[k / 4].xy : pairs[k / 4].zw;
      float t = (k & 1) == 0 ? frame.shutter.x : frame.shutter.y;
      if (!isMotion(b)) break;
      mask = t != 0.0 && uncovers(pixel, own, d, b, t);
    }
  }
  imageStore(mask_img, pixel, vec4(mask ? 1 : 0));
}
