// SPDX-License-Identifier: MIT
// Gather over both layers: at each time sample, the foreground over the background of the pixel; the result is the mean over
// the samples (an extension of Tan, Cui, Bhojan 2020; docs/derivations.md, "Both layers in one gather").
// In:  `color`: raster layer, linear radiance
//      `depth`: view depth, metres; +inf for the sky
//      `id`: instance + 1, geometry + 1; 0 for the sky
//      `velocity`: displacement d of each pixel, px over the exposure
//      `dominant`: longest displacement that reaches each tile, px over the exposure
//      `revealed_color`, `revealed_depth`, `revealed_id`, `revealed_velocity`: these images of the revealed layer
//      `revealed_valid`: above 1/2 where the revealed layer has a surface
//      `velocity_post`, `dominant_post`, `revealed_velocity_post`: displacements after the raster time; absent: the
//        displacements above hold for all times
// Out: `blurred`: linear radiance, alpha 1
// Method: the N time samples t_i of a pixel X are the midpoints (i + 1/2 + jitter)/N of N equal parts of the exposure. The
//   background B of X is the revealed surface at X, or the raster surface if none was revealed.
//   Foreground: two searches begin at X - t_i*d, where d is the tile's dominant displacement in one, d(X) in the other. A texel
//   Y is at X at t_i if |Y + t_i*d(Y) - X| <= max(3/4, |d|/(2N)) px: 3/4 px allow for rounding to a texel, |d|/(2N) is half the
//   distance between two samples. If Y is not at X, the search tries one more texel, X - t_i*d(Y). The nearer of the two
//   surfaces found covers B fully, or in part if it is in front by less than the share `depth_extent` of the depth.
//   Background: the raster texel at Y = X - t_i*d(B), if it has B's instance or is not in front of B. Otherwise the texel
//   revealed at Y, or B itself if none was revealed there (counter `fallback`).
// Fails: misses foregrounds that move by neither displacement, above all if they move against both. Misplaces backgrounds that
//   turn or that meet near X, because d(B) is taken at X. Surfaces behind the revealed layer are missing.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

struct Tap {
  vec3 color;
  float depth;
  Path path;  // motion before or after the raster time, as the caller requests
  uint instance;
};

Tap rasterAt(ivec2 pixel, bool after) {
  return Tap(colorOf(kRaster, pixel), saneDepth(depth_at(pixel).x), pathOf(kRaster, pixel, after), id_at(pixel).x);
}

// Background of a pixel: the revealed surface, or the raster surface if none was revealed. `after`: for times after the raster
// time.
Tap backgroundOf(ivec2 pixel, bool after) {
  if (!isRevealed(pixel)) return rasterAt(pixel, after);
  return Tap(colorOf(kRevealed, pixel), revealedDepth(pixel), pathOf(kRevealed, pixel, after), revealed_id_at(pixel).x);
}

Path dominantOf(ivec2 pixel, bool after) {
  ivec2 tile = pixel / params.tile;
  return straight(vec2(after ? dominant_post_at(tile) : dominant_at(tile)));
}

ivec2 tapFor(ivec2 pixel, Path path, float t) { return nextTexel(pixel, path, t); }

// A surface in front of the background. `share`, 0 to 1: the part of the background that the surface covers.
struct Cover {
  vec3 color;
  float depth;
  float share;
};

const Cover kNoCover = Cover(vec3(0), 0.0, 0.0);

// Raster surface that covers the background `back` at the pixel at time t; kNoCover if no such surface is found. The search
// begins at `texel`. `path`: motion that the search assumes; its length sets the tolerance.
Cover coverAt(ivec2 pixel, Path path, ivec2 texel, float t, Tap back) {
  float tolerance_px = max(0.75, lengthOf(path.d) / float(2 * params.samples));
  for (int i = 0; i < kIterations; ++i) {
    if (!isInside(texel, textureSize(color_tex, 0))) return kNoCover;
    Tap tap = rasterAt(texel, t > 0.0);
    if (isAt(pixel, texel, tap.path, t, tolerance_px))
      return Cover(tap.color, tap.depth, inFrontOf(tap.depth, back.depth, params.depth_extent));
    texel = tapFor(pixel, tap.path, t);
  }
  return kNoCover;
}

// The nearer of two covers. At about equal depths the result is the first one, because otherwise rounding would choose
// between two texels of one surface.
Cover nearer(Cover a, Cover b) {
  if (a.share == 0.0) return b;
  return b.share > 0.0 && inFrontOf(b.depth, a.depth, params.depth_extent) > 0.5 ? b : a;
}

// Colour of the background `back` at the pixel at time t. The raster layer shows the background at the texel where the
// background is at the raster time, unless a surface there is in front of the background. In that case the colour comes
// from the revealed layer or, as a fallback, from `back`.
vec3 backgroundAt(ivec2 pixel, float t, Tap back, inout uint fallbacks) {
  ivec2 texel = tapFor(pixel, back.path, t);
  if (isInside(texel, textureSize(color_tex, 0))) {
    Tap tap = rasterAt(texel, t > 0.0);
    bool is_shown = tap.instance == back.instance || inFrontOf(tap.depth, back.depth, params.depth_extent) == 0.0;
    if (is_shown) return tap.color;
    if (isRevealed(texel)) return colorOf(kRevealed, texel);
  }
  fallbacks += 1u;
  return back.color;
}

void run(ivec2 pixel) {
  float fastest = max(reachOf(dominantOf(pixel, false)), reachOf(dominantOf(pixel, true)));
  if (spreadFactor(frame.shutter) * fastest <= kStaticRadius) {
    imageStore(blurred_img, pixel, vec4(vec3(color_at(pixel)), 1));
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
