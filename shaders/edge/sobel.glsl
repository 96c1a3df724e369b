// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Tan, Cui, Bhojan 2020, Ray Mask; Sobel and Feldman 1968).
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge.
// Kernel 1/4 [1 2 1]^T [-1 0 1]: a unit step responds 1. The depth gradient is divided by the pixel's own depth, so
//   that no scale is built in; depths beyond kFarthest times that count as kFarthest times it, sky among them. The
//   normal gradient is that of all three components; the largest step is 2. Each is divided by its threshold; an edge
//   is where the combination (the larger, the sum, or the smaller of both) exceeds 1. Outside of the picture its
//   border goes on.
// Fails: planes at grazing angles (the depth gradient grows with 1/cos); curved surfaces; sky has no edge of its own.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

const float kFarthest = 16.0;

// Relative depth and normal of a pixel near `pixel`.
vec4 featureAt(ivec2 pixel, ivec2 offset, float depth) {
  ivec2 at = clampToImage(pixel + offset, textureSize(depth_tex, 0));
  float relative = min(saneDepth(texelFetch(depth_tex, at, 0).x) / depth, kFarthest);
  return vec4(finiteColor(texelFetch(normal_tex, at, 0)), relative);
}

vec4 gradient(ivec2 pixel, ivec2 along, ivec2 across, float depth) {
  vec4 ahead = featureAt(pixel, along - across, depth) + 2.0 * featureAt(pixel, along, depth) +
               featureAt(pixel, along + across, depth);
  vec4 behind = featureAt(pixel, -along - across, depth) + 2.0 * featureAt(pixel, -along, depth) +
                featureAt(pixel, -along + across, depth);
  return 0.25 * (ahead - behind);
}

float sizeOf(vec2 value) {
#if PARAM_norm == norm_l1
  return abs(value.x) + abs(value.y);
#else
  return length(value);
#endif
}

float combined(float depth_response, float normal_response) {
#if PARAM_combine == combine_sum
  return depth_response + normal_response;
#elif PARAM_combine == combine_and
  return min(depth_response, normal_response);
#else
  return max(depth_response, normal_response);
#endif
}

bool isWanted(ivec2 pixel) {
#if HAS_where
  return texelFetch(where_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

void run(ivec2 pixel) {
  float depth = saneDepth(texelFetch(depth_tex, pixel, 0).x);
  bool edge = false;
  if (isWanted(pixel) && depth > 0.0 && depth <= kLargestFinite) {
    vec4 in_x = gradient(pixel, ivec2(1, 0), ivec2(0, 1), depth);
    vec4 in_y = gradient(pixel, ivec2(0, 1), ivec2(1, 0), depth);
    float depth_step = sizeOf(vec2(in_x.w, in_y.w));
    float normal_step = sizeOf(vec2(length(vec3(in_x)), length(vec3(in_y))));
    edge = combined(depth_step / params.depth_threshold, normal_step / params.normal_threshold) > 1.0;
  }
  imageStore(edge_img, pixel, vec4(edge ? 1 : 0));
}
