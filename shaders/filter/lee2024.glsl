// SPDX-License-Identifier: MIT
// Blur by a search in up to four full layers for the nearest surface at a pixel at each time sample (Lee, Kwon, Oh 2024,
// "Real-Time Motion Blur Using Multi-Layer Motion Vectors", Applied Sciences 14, 4626). The search follows displacements
// backwards, for any anchor.
// In:  `color`: linear radiance of the first layer.
//      `depth`: view depth of the first layer, metres; +inf for the sky.
//      `velocity`: displacement of the first layer, px over the exposure.
//      `layer_2_*`, `layer_3_*`, `layer_4_*`: color, depth and velocity of the surfaces behind the first layer, for every pixel
//        (optional).
//      `id`: instance + 1, geometry + 1 of the first layer; read for the counter `varied` alone.
//      `dominant`: longest displacement per tile of the first two layers, px over the exposure (optional).
//      `deep_dominant`: longest displacement per tile of the third and fourth layer, px over the exposure (optional).
// Out: `blurred`: linear radiance, alpha 1.
// Method: for pixel X, sample i of N is at the time t_i at the share (i + 1/2 + jitter)/N of the exposure. For each searched
//   displacement g and each layer, test the texel Y = X - t_i * g, clamped to the image. Y counts if its own displacement
//   differs from g by at most `agreement` px, and by at most half of the longer of both (or half a pixel, if that is more). The
//   sample is the nearest texel that counts; at equal depths, the texel of the first g. The result is the mean of the samples
//   found, or the colour of X if no sample is found.
//   The searched displacements are the displacements of X in all layers and the dominant ones of the tile. The text of the
//   paper does not state how it finds surfaces that pass over a pixel; here the dominant displacements find them, as in other
//   filters.
//   The counter `varied` counts samples that may show a deeper layer by mistake: the path of X's own surface leads to a
//   texel of the same surface in the first layer, but this texel is rejected, because its displacement differs too
//   much.
// Fails: misses surfaces in no layer, and surfaces with other displacements than the pixel's own and the longest of its tile.
#include "lib/times.glsl"
#include "mixin/jitter.glsl"
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

const int kLayers = 1 + HAS_layer_2_depth + HAS_layer_3_depth + HAS_layer_4_depth;
// Largest number of searched displacements: four of the pixel (one per layer) and two of its tile.
const int kMost = 6;

// Depth a counts as nearer than depth b if a < kSameDepth * b. Depths that differ by less than 2^-16 of the depth thus
// count as equal: rounding alone can separate the depths of one surface by this much.
const float kSameDepth = 1.0 - 1.0 / 65536.0;

// Distance, px over the exposure, within which two displacements count as one: they nearly always lead to the same texels.
const float kSamePath = 1.0 / 16.0;

vec3 colorOf(int layer, ivec2 at) {
  if (layer == 1) return finiteColor(layer_2_color_at(at));
  if (layer == 2) return finiteColor(layer_3_color_at(at));
  if (layer == 3) return finiteColor(layer_4_color_at(at));
  return finiteColor(color_at(at));
}

float depthOf(int layer, ivec2 at) {
  if (layer == 1) return saneDepth(layer_2_depth_at(at).x);
  if (layer == 2) return saneDepth(layer_3_depth_at(at).x);
  if (layer == 3) return saneDepth(layer_4_depth_at(at).x);
  return saneDepth(depth_at(at).x);
}

vec4 displacementOf(int layer, ivec2 at) {
  if (layer == 1) return layer_2_velocity_at(at);
  if (layer == 2) return layer_3_velocity_at(at);
  if (layer == 3) return layer_4_velocity_at(at);
  return velocity_at(at);
}

vec2 limitedDisplacementOf(int layer, ivec2 at) {
  return clampLength(finiteDisplacement(displacementOf(layer, at)), limitPx());
}

// Displacements that a pixel's search follows, and the length of the longest one.
struct Searched {
  vec2 displacements[kMost];  // px over the exposure
  int count;
  float longest;              // px over the exposure
};

// Adds the displacement d, unless it is close to a displacement in the list.
void search(inout Searched searched, vec2 d) {
  for (int k = 0; k < searched.count; ++k)
    if (lengthOf(searched.displacements[k] - d) <= kSamePath) return;
  searched.displacements[searched.count] = d;
  searched.count += 1;
  searched.longest = max(searched.longest, lengthOf(d));
}

void searchDominant(inout Searched searched, ivec2 tile) {
#if HAS_dominant
  search(searched, vec2(dominant_at(tile)));
#endif
#if HAS_deep_dominant
  search(searched, vec2(deep_dominant_at(tile)));
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

// Nearest surface found for a time sample: its layer (0 is the first), texel and view depth.
struct Nearest {
  int layer;  // -1: no surface
  ivec2 at;
  float depth;
};

// True if two displacements differ by at most `agreement` px and by at most half of the longer one (or half a pixel, if that is
// more). A displacement of 0 and a displacement of more than half a pixel therefore never agree, for any value of `agreement`.
bool agree(vec2 a, vec2 b) {
  float apart = lengthOf(a - b);
  return apart <= params.agreement && apart <= max(0.5 * max(lengthOf(a), lengthOf(b)), 0.5);
}

// True if the displacement of a texel agrees with the displacement d that the search followed to the texel.
bool moveAgrees(int layer, ivec2 at, vec2 d) { return agree(limitedDisplacementOf(layer, at), d); }

// The nearer of two surfaces: the surface `nearest`, found so far, and the surface of the texel `at` of a layer. The
// displacement d leads to this texel. The texel counts only if its own displacement agrees with d.
Nearest nearer(Nearest nearest, int layer, ivec2 at, vec2 d) {
  if (!moveAgrees(layer, at, d)) return nearest;
  float depth = depthOf(layer, at);
  if (nearest.layer >= 0 && depth >= nearest.depth * kSameDepth) return nearest;
  return Nearest(layer, at, depth);
}

// Nearest surface that is at the pixel at time t, over all searched displacements and layers.
Nearest sampleAt(ivec2 pixel, Searched searched, float t, ivec2 size) {
  Nearest nearest = Nearest(-1, pixel, 0.0);
  for (int k = 0; k < searched.count; ++k) {
    vec2 d = searched.displacements[k];
    ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(d, t)), size);
    for (int layer = 0; layer < kLayers; ++layer) nearest = nearer(nearest, layer, at, d);
  }
  return nearest;
}

// True if the path of the pixel's own surface, followed back from time t, leads to a texel of this surface with a different
// displacement.
bool isVaried(ivec2 pixel, float t, ivec2 size) {
  vec2 d = limitedDisplacementOf(0, pixel);
  ivec2 at = clampToImage(pixel + roundSymmetric(tapOffset(d, t)), size);
  return id_at(at).xy == id_at(pixel).xy && !moveAgrees(0, at, d);
}

void run(ivec2 pixel) {
  vec3 own = vec3(color_at(pixel));
  Searched searched = searchedAt(pixel);
  if (spreadFactor(frame.shutter) * searched.longest <= kStaticRadius) {
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
    Nearest nearest = sampleAt(pixel, searched, t, size);
    if (nearest.layer < 0) continue;
    if (nearest.layer > 0 && isVaried(pixel, t, size)) varied += 1u;
    sum += toSum(colorOf(nearest.layer, nearest.at));
    found += 1;
  }
  if (found < params.samples) count_missed(uint(params.samples - found));
  if (varied > 0u) count_varied(varied);
  imageStore(blurred_img, pixel, vec4(found > 0 ? fromSum(sum / float(found)) : own, 1));
}
