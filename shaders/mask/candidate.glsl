// SPDX-License-Identifier: MIT
// Displaced-position test (Tan, Cui, Bhojan 2020, Ray Mask): may this pixel show what is behind it while it moves away?
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), velocity (px over the exposure).
// Out: candidate, 1 if the pixel moves by min_displacement or more and where its surface points to, displaced against
//   the exposure (X + d for an exposure before the capture, X - d after, both halves around it), is another instance,
//   farther by more than depth_margin of this pixel's depth. Displaced off the picture it is a candidate too (nobody
//   knows better) and counted. Sky is nobody's foreground. With several taps the same is asked at equal parts of the
//   way, ends included: four at 1/4, 1/2, 3/4 and 1.
// Fails: one tap jumps over gaps (spokes of a fan), several over narrower ones; blind to self-occlusion of one instance
//   and to motion of the background.
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
