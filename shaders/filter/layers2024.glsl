// SPDX-License-Identifier: MIT
// Lee, Kwon, Oh 2024, "Real-Time Motion Blur Using Multi-Layer Motion Vectors" (Applied Sciences 14, 4626), for any anchor.
// In:  color (linear), depth (view depth, sky +inf), velocity (px over the exposure) of what is seen at the capture;
//      layer_2_* to layer_4_*: the same of what lies behind it, all over the picture;
//      dominant, deep_dominant (px over the exposure, per tile): of the first two layers, and of those behind (absent: none).
// Out: blurred (linear, alpha 1).
// For each t_i at the midpoints (i + 1/2 + jitter)/N of the exposure, each displacement g searched and each layer: the texel
//   Y = X - t_i*g (outside of the picture the one at its border) counts if its own displacement is within `agreement` of g, and
//   nearer to it than half of the longer one. The nearest counts alone; of equal depths that of the first displacement.
//   The mean over the i at which there is any is the result.
// Searched: the displacements of X in all layers, and those of its tile. The paper's text says that a colour is taken where it
//   shares its displacement with where the search began; which displacements begin at a pixel that something else passes over it
//   was not at hand for: here they are found as other filters find them.
//   id (instance + 1, geometry + 1) of what is seen at the capture, by which it is counted where its own path leads to another
//   part of it that moves otherwise, and something behind it is taken.
// Fails: what is in no layer; displacements that are neither the pixel's nor its tile's longest.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

const int kLayers = 1 + HAS_layer_2_depth + HAS_layer_3_depth + HAS_layer_4_depth;
const int kMost = 6;  // displacements: of four layers and two of the tile

// Rounding tells surfaces apart that are one: nearer by less than this share is equal.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// Displacements as near to each other as this lead to the same texels, px.
const float kSamePath = 1.0 / 16.0;

vec3 colorOf(int layer, ivec2 at) {
#if HAS_layer_2_color
  if (layer == 1) return finiteColor(texelFetch(layer_2_color_tex, at, 0));
#endif
#if HAS_layer_3_color
  if (layer == 2) return finiteColor(texelFetch(layer_3_color_tex, at, 0));
#endif
#if HAS_layer_4_color
  if (layer == 3) return finiteColor(texelFetch(layer_4_color_tex, at, 0));
#endif
  return finiteColor(texelFetch(color_tex, at, 0));
}

float depthOf(int layer, ivec2 at) {
#if HAS_layer_2_depth
  if (layer == 1) return saneDepth(texelFetch(layer_2_depth_tex, at, 0).x);
#endif
#if HAS_layer_3_depth
  if (layer == 2) return saneDepth(texelFetch(layer_3_depth_tex, at, 0).x);
#endif
#if HAS_layer_4_depth
  if (layer == 3) return saneDepth(texelFetch(layer_4_depth_tex, at, 0).x);
#endif
  return saneDepth(texelFetch(depth_tex, at, 0).x);
}

vec4 displacementOf(int layer, ivec2 at) {
#if HAS_layer_2_velocity
  if (layer == 1) return texelFetch(layer_2_velocity_tex, at, 0);
#endif
#if HAS_layer_3_velocity
  if (layer == 2) return texelFetch(layer_3_velocity_tex, at, 0);
#endif
#if HAS_layer_4_velocity
  if (layer == 3) return texelFetch(layer_4_velocity_tex, at, 0);
#endif
  return texelFetch(velocity_tex, at, 0);
}

vec2 limitedDisplacementOf(int layer, ivec2 at) {
  return clampLength(finiteDisplacement(displacementOf(layer, at)), limitPx());
}

struct Searched {
  vec2 displacements[kMost];  // px over the exposure
  int count;
  float longest;  // px
};

void search(inout Searched searched, vec2 d) {
  for (int k = 0; k < searched.count; ++k)
    if (lengthOf(searched.displacements[k] - d) <= kSamePath) return;
  searched.displacements[searched.count] = d;
  searched.count += 1;
  searched.longest = max(searched.longest, lengthOf(d));
}

void searchDominant(inout Searched searched, ivec2 tile) {
#if HAS_dominant
  search(searched, vec2(texelFetch(dominant_tex, tile, 0)));
#endif
#if HAS_deep_dominant
  search(searched, vec2(texelFetch(deep_dominant_tex, tile, 0)));
#endif
}

Searched searchedAt(ivec2 pixel) {
  Searched searched;
  searched.count = 0;
  searched.longest = 0.0;
  for (int layer = 0; layer < kLayers; ++layer) search(searched, limitedDisplacementOf(layer, pixel));
  searchDominant(searched, pixel / params.tile);
  return searched;
}

struct Seen {
  int layer;  // -1: nothing
  ivec2 at;
  float depth;
};

// Are two displacements one? What rests agrees with nothing that moves by a pixel, however much may differ.
bool agree(vec2 a, vec2 b) {
  float apart = lengthOf(a - b);
  return apart <= params.agreement && apart <= max(0.5 * max(lengthOf(a), lengthOf(b)), 0.5);
}

// True if the displacement of a texel agrees with the displacement d that leads to the texel.
bool comes(int layer, ivec2 at, vec2 d) { return agree(limitedDisplacementOf(layer, at), d); }

// The nearer of what was seen and what a layer has where a path leads.
Seen nearer(Seen seen, int layer, ivec2 at, vec2 d) {
  if (!comes(layer, at, d)) return seen;
  float depth = depthOf(layer, at);
  if (seen.layer >= 0 && depth >= seen.depth * kSameDepth) return seen;
  return Seen(layer, at, depth);
}

Seen seenAt(ivec2 pixel, Searched searched, float t, ivec2 size) {
  Seen seen = Seen(-1, pixel, 0.0);
  for (int k = 0; k < searched.count; ++k) {
    vec2 d = searched.displacements[k];
    ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(d, t)), size);
    for (int layer = 0; layer < kLayers; ++layer) seen = nearer(seen, layer, at, d);
  }
  return seen;
}

// Does the path of what is seen at the pixel lead to more of it, which moves otherwise?
bool isVaried(ivec2 pixel, float t, ivec2 size) {
  vec2 d = limitedDisplacementOf(0, pixel);
  ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(d, t)), size);
  return texelFetch(id_tex, at, 0).xy == texelFetch(id_tex, pixel, 0).xy && !comes(0, at, d);
}

void run(ivec2 pixel) {
  vec3 own = vec3(texelFetch(color_tex, pixel, 0));
  Searched searched = searchedAt(pixel);
  if (reachFactor(frame.shutter) * searched.longest <= kStillRadius) {
    imageStore(blurred_img, pixel, vec4(own, 1));
    return;
  }

  ivec2 size = textureSize(color_tex, 0);
  float jitter = jitterOf(pixel);
  vec3 sum = vec3(0);
  int found = 0;
  uint varied = 0u;
  for (int i = 0; i < params.samples; ++i) {
    float t = sampleTime(i, params.samples, jitter);
    Seen seen = seenAt(pixel, searched, t, size);
    if (seen.layer < 0) continue;
    if (seen.layer > 0 && isVaried(pixel, t, size)) varied += 1u;
    sum += toSum(colorOf(seen.layer, seen.at));
    found += 1;
  }
  if (found < params.samples) count_missed(uint(params.samples - found));
  if (varied > 0u) count_varied(varied);
  imageStore(blurred_img, pixel, vec4(found > 0 ? fromSum(sum / float(found)) : own, 1));
}
