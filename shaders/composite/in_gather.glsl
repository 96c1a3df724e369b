// SPDX-License-Identifier: MIT
// One gather over both layers: at each time sample what covers the pixel then, else the background that is there then,
// read from the revealed layer where raster saw something in front of it.
// In:  color (linear), depth (view depth, sky +inf), id, velocity (px over the exposure), dominant (the same, per tile)
//      of what raster saw; revealed_color, _depth, _id, _velocity, _valid (> 1/2) of what lies behind; after_*,
//      revealed_after_*: displacements for times after the capture, where the exposure is split there.
// Out: blurred (linear, alpha 1).
// The background B of X is what was revealed there, else what raster saw there. For t_i at the midpoints
//   (i + 1/2 + jitter)/N of the exposure:
//   Foreground: the tap Y = X - t_i*d along the tile's dominant displacement, and that along X's own. A tap that by its
//   own motion is not at X at t_i (|Y + t_i*d(Y) - X| > max(3/4, |d|/(2N)) px) leads once to another, by its own d. Of
//   those that are, the nearest counts to the degree that it is in front of B.
//   Background: the tap Y = X - t_i*d(B). Where raster shows B's instance, or nothing in front of it, that; else what
//   was revealed at Y; else B itself (counter `fallback`).
// Each t_i has the weight 1/N: weights add up to 1, and coverage and background vary together as they do in truth.
// Fails: see passes/composite/in_gather.lua.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

struct Tap {
  vec3 color;
  float depth;
  Path path;  // in the part of the exposure that was asked for
  uint instance;
};

Tap rasterAt(ivec2 pixel, bool after) {
  return Tap(colorOf(kRaster, pixel), saneDepth(texelFetch(depth_tex, pixel, 0).x), pathOf(kRaster, pixel, after),
             texelFetch(id_tex, pixel, 0).x);
}

// The background of a pixel: what was revealed there, else what raster saw there.
Tap backgroundOf(ivec2 pixel, bool after) {
  if (!isRevealed(pixel)) return rasterAt(pixel, after);
  return Tap(colorOf(kRevealed, pixel), revealedDepth(pixel), pathOf(kRevealed, pixel, after),
             texelFetch(revealed_id_tex, pixel, 0).x);
}

Path dominantOf(ivec2 pixel, bool after) {
  ivec2 tile = pixel / params.tile;
#if HAS_after_dominant
  if (after) return straight(vec2(texelFetch(after_dominant_tex, tile, 0)));
#endif
  return straight(vec2(texelFetch(dominant_tex, tile, 0)));
}

ivec2 tapFor(ivec2 pixel, Path path, float t) { return asked(pixel, path, t); }

// A surface in front of the background, to the degree `share`.
struct Cover {
  vec3 color;
  float depth;
  float share;
};

const Cover kNoCover = Cover(vec3(0), 0.0, 0.0);

// Raster surface in front of the background at the pixel at t, from the tap `now` on, if the surface moves by about `path`.
Cover coverAt(ivec2 pixel, Path path, ivec2 now, float t, Tap back) {
  float tolerance_px = max(0.75, lengthOf(path.d) / float(2 * params.samples));
  for (int guess = 0; guess < kGuesses; ++guess) {
    if (!isInside(now, textureSize(color_tex, 0))) return kNoCover;
    Tap tap = rasterAt(now, t > 0.0);
    if (isAt(pixel, now, tap.path, t, tolerance_px))
      return Cover(tap.color, tap.depth, inFrontOf(tap.depth, back.depth, params.depth_extent));
    now = tapFor(pixel, tap.path, t);
  }
  return kNoCover;
}

// The first where both are about equally far away: of one surface, rounding would choose.
Cover nearer(Cover a, Cover b) {
  if (a.share == 0.0) return b;
  return b.share > 0.0 && inFrontOf(b.depth, a.depth, params.depth_extent) > 0.5 ? b : a;
}

// The background that is at the pixel at t. What raster saw there hides it if it was in front at the capture.
vec3 backgroundAt(ivec2 pixel, float t, Tap back, inout uint fallbacks) {
  ivec2 now = tapFor(pixel, back.path, t);
  if (isInside(now, textureSize(color_tex, 0))) {
    Tap tap = rasterAt(now, t > 0.0);
    bool in_view = tap.instance == back.instance || inFrontOf(tap.depth, back.depth, params.depth_extent) == 0.0;
    if (in_view) return tap.color;
    if (isRevealed(now)) return colorOf(kRevealed, now);
  }
  fallbacks += 1u;
  return back.color;
}

void run(ivec2 pixel) {
  float fastest = max(reachOf(dominantOf(pixel, false)), reachOf(dominantOf(pixel, true)));
  if (reachFactor(frame.shutter) * fastest <= kStillRadius) {
    imageStore(blurred_img, pixel, vec4(vec3(texelFetch(color_tex, pixel, 0)), 1));
    return;
  }

  float jitter = jitterOf(pixel);
  vec3 sum = vec3(0);
  uint fallbacks = 0u;
  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter);
    Tap back = backgroundOf(pixel, t > 0.0);
    Path dominant = dominantOf(pixel, t > 0.0), own = pathOf(kRaster, pixel, t > 0.0);
    Cover cover = nearer(coverAt(pixel, dominant, tapFor(pixel, dominant, t), t, back),
                         coverAt(pixel, own, tapFor(pixel, own, t), t, back));
    vec3 color = cover.color;
    if (cover.share < 1.0) color = mix(backgroundAt(pixel, t, back, fallbacks), color, cover.share);
    sum += toSum(color);
  }
  if (fallbacks > 0u) count_fallback(fallbacks);
  imageStore(blurred_img, pixel, vec4(fromSum(sum / float(params.samples)), 1));
}
