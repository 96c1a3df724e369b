// SPDX-License-Identifier: MIT
// The average of `taps` colours along the pixel's own displacement, centred on the pixel.
// In:  color (linear), velocity (px over the exposure, y down).
// Out: color (linear, alpha 1).
// Fails: nothing is blurred over what is at rest beside it.
void run(ivec2 pixel) {
  vec2 displacement = vec2(texelFetch(velocity_tex, pixel, 0));
  ivec2 last = textureSize(color_tex, 0) - 1;
  vec3 mean = vec3(0);
  for (int i = 0; i < params.taps; ++i) {
    float along = (float(i) + 0.5) / float(params.taps) - 0.5;
    ivec2 tap = clamp(pixel + ivec2(round(along * displacement)), ivec2(0), last);
    mean += (vec3(texelFetch(color_tex, tap, 0)) - mean) / float(i + 1);  // exact where all are equal
  }
  imageStore(color_img, pixel, vec4(mean, 1));
}
