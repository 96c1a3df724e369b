// SPDX-License-Identifier: MIT
// Displaced-position test of the ray mask: marks moving pixels that land on another, farther instance when displaced by their
// motion (Tan, Cui, Bhojan 2020, section Ray Mask). At such a pixel the background is likely to be disoccluded.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `id`: instance + 1; 0 for the sky.
//      `velocity`: displacement d of each pixel's surface, px over the exposure.
// Out: `candidate`: 1 at marked pixels, otherwise 0.
// Method: a pixel X with |d| >= `min_displacement` is tested at X + d if the exposure ends at the raster time, at X - d if it
//   starts there, and at X + d/2 and X - d/2 if it is centred. X is marked if the tested pixel shows another instance, farther
//   than X by more than `depth_margin` times the depth of X. X is also marked if the position is outside the image, where the
//   surface is unknown (counter `off_screen`). Pixels of the sky are not marked.
//   With several `taps` the way to each position is divided into that number of equal parts, and the end of each part
//   is tested: with four taps at 1/4, 1/2, 3/4 and 1 of the way.
// Fails: one tap skips gaps, for example between the spokes of a fan; several taps skip narrower gaps. Misses silhouettes of an
//   instance in front of itself, and disocclusions by the motion of the background.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

// True if the pixel `displaced` shows another instance that is farther than `pixel` by more than the margin.
bool isBeyond(ivec2 pixel, ivec2 displaced) {
  if (texelFetch(id_tex, displaced, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  float depth = saneDepth(texelFetch(depth_tex, pixel, 0).x);
  return saneDepth(texelFetch(depth_tex, displaced, 0).x) - depth > params.depth_margin * depth;
}

// True if a tested position shows another, farther instance or is outside the image. The `taps` tested positions divide
// the way from the pixel to its displaced position evenly. `d`: displacement of the pixel. `t`: time of the displaced
// position, shutter open or shutter close. If `t` is 0 (the raster time), the pixel is not displaced, and the result is
// false.
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
