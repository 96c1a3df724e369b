// SPDX-License-Identifier: MIT
// In:  bins. Out: drawn.
void run(ivec2 pixel) { imageStore(drawn_img, pixel, vec4(float(bins_buf.entries[pixel.x]))); }
