// SPDX-License-Identifier: MIT
// Displaced-position test of the ray mask. It marks moving pixels that, displaced by their motion, land on another instance
// that is farther away (Tan, Cui, Bhojan 2020, section Ray Mask).
// In:  depth: view depth, metres; +inf for the sky.
//      id: instance + 1; 0 for the sky.
//      velocity: displacement d, px over the exposure.
// Out: candidate: 1 where the test marks the pixel, otherwise 0.
// Method: a pixel X with |d| >= `min_displacement` is tested at X + d if the exposure lies before the raster time, at X - d if
//   it lies after, and at both X + d/2 and X - d/2 if it lies around. X is marked if the pixel there shows another instance
//   that is farther by more than `depth_margin` times the depth of X. If the position is outside the image, X is marked too,
//   because the surface there is unknown (counter `off_screen`). Sky pixels are not marked.
//   With several `taps` the test is repeated at equal parts of the way: four taps at 1/4, 1/2, 3/4 and 1.
// Fails: one tap skips gaps (spokes of a fan), and several taps skip narrower gaps. Self-occlusion of one instance and motion
//   of the background are not detected.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

bool isBeyond(ivec2 pixel, ivec2 displaced) {
  if (texelFetch(id_tex, displaced, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  float depth = saneDepth(texelFetch(depth_tex, pixel, 0).x);
  return saneDepth(texelFetch(depth_tex, displaced, 0).x) - depth > params.depth_margin * depth;
}

bool isCandidate(ivec2 pixel, vec2 d, float t) {
  if (t == 0.0) return false;
  for (int i = 1; i <= params.taps; ++i) {
    ivec2 displaced = pixel + roundSymmetric(tapOffset(d, t * (float(i) / float(params.taps))));
    if (!isInside(displaced, textureSize(depth_tex, 0))) {
      count_off_screen(1u);
      return true;
    }
    if (isBeyond(pixel, displaced)) return true;
  }
  return false;
}

void run(ivec2 pixel) {
  vec2 d = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  d = clampLength(d, limitPx());
  bool candidate = false;
  if (texelFetch(id_tex, pixel, 0).x != 0u && lengthOf(d) >= params.min_displacement) {
    bool at_open = isCandidate(pixel, d, frame.shutter.x);
    bool at_close = isCandidate(pixel, d, frame.shutter.y);
    candidate = at_open || at_close;
  }
  imageStore(candidate_img, pixel, vec4(candidate ? 1 : 0));
}
