// SPDX-License-Identifier: MIT
// The pixels behind which something hidden at the capture becomes visible within the exposure.
//
// A point hidden behind pixel y moves by b, the foreground at y by d: at time t the point is at y + b*t, where the
// foreground shows what is now at y + b*t - d*t = y - t*(d - b). So it is seen if the path y - t*(d - b) leaves the
// foreground within the window: motion relative to the background decides, not motion, and a foreground at rest has its
// mask where the background moves (a tracking shot).
//
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), velocity (px over the exposure);
//      motions_0 .. motions_3: displacements found around each tile, the candidates for b.
// Out: mask, 1 if for one candidate b the path meets a pixel q of another instance, not nearer (by `occluder`) than the
//   last pixel of y's own instance met, that does move by about b (within a pixel, or match * |d - b|). If q moves
//   otherwise the path is walked once more with q's own displacement for b. Candidates are rough where a background's
//   motion varies; q's is exact. A path that ends behind an occluder goes on to where that ends. One step per pixel
//   of the path, plus `margin` px: an overmarked pixel costs a ray, a missed one an error. Paths that leave the picture
//   end there: nobody knows what is outside (counter off_screen).
// Fails: background whose motion is visible nowhere near; self-occlusion of one instance; more than eight movements.
#include "lib/blur.glsl"
#include "lib/motions.glsl"
#include "lib/sanitise.glsl"

struct Walk {
  bool crosses;     // a silhouette beyond which things move as supposed
  bool meets;       // some silhouette
  vec2 d_beyond;    // displacement beyond the first one
  bool off_screen;
};

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), params.limit * float(frame.size.x));
}

// Along y - t*(d - b) from the capture to time t.
Walk walked(ivec2 pixel, vec2 d, vec2 b, float t) {
  Walk walk = Walk(false, false, vec2(0), false);
  vec2 whole = tapOffset(d - b, t);
  float whole_px = lengthOf(whole);
  if (whole_px < 0.5) return walk;

  uint own = texelFetch(id_tex, pixel, 0).x;
  float own_depth = saneDepth(texelFetch(depth_tex, pixel, 0).x);
  float matching_px = max(1.0, params.match * lengthOf(d - b));
  int steps = int(ceil(whole_px)) + params.margin;
  // Behind what stands in front the silhouette may end unseen: the walk goes on to where that ends.
  int longest = steps + int(ceil(params.limit * float(frame.size.x)));
  bool occluded = false;
  for (int i = 1; i <= steps || (occluded && i <= longest); ++i) {
    ivec2 at = pixel + roundSymmetric(whole * (float(i) / whole_px));
    if (!isInside(at, textureSize(id_tex, 0))) {
      walk.off_screen = true;
      return walk;
    }
    float depth = saneDepth(texelFetch(depth_tex, at, 0).x);
    if (texelFetch(id_tex, at, 0).x == own) {
      if (i > steps) return walk;
      own_depth = depth;
      occluded = false;
      continue;
    }
    // An occluder: the foreground may go on behind it. A background that slants, as the ground an object stands on, is
    // nearer by a little where the path ends, though it is farther at the pixel itself.
    occluded = depth < own_depth * (1.0 - params.occluder);
    if (occluded) continue;
    vec2 d_beyond = displacementAt(at);
    if (lengthOf(d_beyond - b) <= matching_px) {
      walk.crosses = true;
      return walk;
    }
    if (!walk.meets) walk.d_beyond = d_beyond;
    walk.meets = true;
  }
  return walk;
}

bool uncovers(ivec2 pixel, vec2 d, vec2 b, float t) {
  Walk walk = walked(pixel, d, b, t);
  if (!walk.crosses && walk.meets) walk = walked(pixel, d, walk.d_beyond, t);
  if (walk.off_screen) count_off_screen(1u);
  return walk.crosses;
}

bool uncoversWithin(ivec2 pixel, vec2 d, vec2 b) {
  if (!isMotion(b)) return false;
  if (frame.shutter.x < 0.0 && uncovers(pixel, d, b, frame.shutter.x)) return true;
  return frame.shutter.y > 0.0 && uncovers(pixel, d, b, frame.shutter.y);
}

bool anyUncovers(ivec2 pixel, vec2 d, vec4 pair) {
  return uncoversWithin(pixel, d, vec2(pair.x, pair.y)) || uncoversWithin(pixel, d, vec2(pair.z, pair.w));
}

void run(ivec2 pixel) {
  bool mask = false;
  if (texelFetch(id_tex, pixel, 0).x != 0u) {
    ivec2 tile = pixel / params.tile;
    vec2 d = displacementAt(pixel);
    mask = anyUncovers(pixel, d, texelFetch(motions_0_tex, tile, 0)) ||
           anyUncovers(pixel, d, texelFetch(motions_1_tex, tile, 0)) ||
           anyUncovers(pixel, d, texelFetch(motions_2_tex, tile, 0)) ||
           anyUncovers(pixel, d, texelFetch(motions_3_tex, tile, 0));
  }
  imageStore(mask_img, pixel, vec4(mask ? 1 : 0));
}
