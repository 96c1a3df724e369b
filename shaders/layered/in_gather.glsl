// SPDX-License-Identifier: MIT
// One gather over both layers: the mean over the time samples of the foreground at the pixel over its background (an extension
// of Tan, Cui, Bhojan 2020; docs/derivations.md, "Both in one gather").
// In:  color: raster layer, linear.
//      depth: view depth, metres; +inf for the sky.
//      id: instance + 1, geometry + 1; 0 for the sky.
//      velocity: displacement d, px over the exposure.
//      dominant: longest displacement that reaches each tile, px over the exposure.
//      revealed_color, revealed_depth, revealed_id, revealed_velocity: the same images of the revealed layer.
//      revealed_valid: > 1/2 where the revealed layer has a surface.
//      velocity_post, dominant_post, revealed_velocity_post: displacements after the raster time (absent: as before it).
// Out: blurred: linear, alpha 1.
// Method: the background B of a pixel X is the surface revealed at X, or the raster surface if none was revealed. The time
//   samples t_i are the midpoints (i + 1/2 + jitter)/N of the exposure. Each has the weight 1/N.
//   Foreground: two searches begin at X - t_i*d, with the tile's dominant displacement and with that at X as d. A tap Y is at X
//   at t_i if |Y + t_i*d(Y) - X| <= max(3/4, |d|/(2N)) px (rounding to a texel; half the distance between two samples). If not,
//   one more tap follows, by d(Y). The nearer surface found covers B to the degree that it is in front of B (depth_extent).
//   Background: the raster texel at Y = X - t_i*d(B) if it has B's instance or is not in front of B. Otherwise the texel
//   revealed at Y, or B itself if none was revealed there (counter `fallback`).
//   Coverage and background vary together over time, as in ground truth.
// Fails: foregrounds that move like neither displacement, above all against them; backgrounds that turn or meet other
//   backgrounds, because d(B) is taken at X; surfaces behind the revealed layer.
#include "mixin/limit.glsl"
#include "mixin/jitter.glsl"
#include "mixin/layers.glsl"
#include "mixin/search.glsl"
#include "lib/times.glsl"
#include "lib/sanitise.glsl"

struct Tap {
  vec3 color;
  float depth;
  Path path;  // before or after the raster time
  uint instance;
};

Tap rasterAt(ivec2 pixel, bool after) {
  return Tap(colorOf(kRaster, pixel), saneDepth(depth_at(pixel).x), pathOf(kRaster, pixel, after), id_at(pixel).x);
}

// Background of a pixel: the revealed surface, or the raster surface if none was revealed.
Tap backgroundOf(ivec2 pixel, bool after) {
  if (!isRevealed(pixel)) return rasterAt(pixel, after);
  return Tap(colorOf(kRevealed, pixel), revealedDepth(pixel), pathOf(kRevealed, pixel, after), revealed_id_at(pixel).x);
}

Path dominantOf(ivec2 pixel, bool after) {
  ivec2 tile = pixel / params.tile;
  return straight(vec2(after ? dominant_post_at(tile) : dominant_at(tile)));
}

ivec2 tapFor(ivec2 pixel, Path path, float t) { return nextTexel(pixel, path, t); }

// A surface in front of the background. `share`, 0 to 1: coverage of the background.
struct Cover {
  vec3 color;
  float depth;
  float share;
};

const Cover kNoCover = Cover(vec3(0), 0.0, 0.0);

// Raster surface that covers the background at the pixel at time t, searched from the texel `now`. The search assumes motion by
// about `path`, which sets the tolerance.
Cover coverAt(ivec2 pixel, Path path, ivec2 now, float t, Tap back) {
  float tolerance_px = max(0.75, lengthOf(path.d) / float(2 * params.samples));
  for (int fallback_estimate = 0; fallback_estimate < kIterations; ++fallback_estimate) {
    if (!isInside(now, textureSize(color_tex, 0))) return kNoCover;
    Tap tap = rasterAt(now, t > 0.0);
    if (isAt(pixel, now, tap.path, t, tolerance_px))
      return Cover(tap.color, tap.depth, inFrontOf(tap.depth, back.depth, params.depth_extent));
    now = tapFor(pixel, tap.path, t);
  }
  return kNoCover;
}

// The nearer of two covers. At about equal depths the first: rounding would choose between two taps of one surface.
Cover nearer(Cover a, Cover b) {
  if (a.share == 0.0) return b;
  return b.share > 0.0 && inFrontOf(b.depth, a.depth, params.depth_extent) > 0.5 ? b : a;
}

// Colour of the background at the pixel at time t. A raster texel in front of the background at the raster time hides it.
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
