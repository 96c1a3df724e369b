// SPDX-License-Identifier: MIT
// In:  color; the pixels of `listed`. Out: copied, times, bins.
void run(ivec2 pixel) {
  float red = texelFetch(color_tex, pixel, 0).r;
  imageStore(copied_img, pixel, vec4(red));
  imageStore(times_img, pixel, imageLoad(times_img, pixel) + 1u);
  atomicAdd(bins_buf.entries[clamp(int(red * 16.0), 0, 15)], 1u);
}
