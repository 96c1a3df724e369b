// SPDX-License-Identifier: MIT
// Does no tile take part in samples for those that have `least_budget` or more?
// In:  rate (one texel: y the most samples that any tile gets).  Out: stop, one pixel: 1 if none does.
void run(ivec2 pixel) {
  bool met = texelFetch(rate_tex, ivec2(0), 0).y < params.least_budget;
  imageStore(stop_img, pixel, vec4(met ? 1 : 0));
}
