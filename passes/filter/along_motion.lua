-- SPDX-License-Identifier: MIT
-- One level of a wavelet filter along the motion, guided by variance. Oberberger, Chajdas, Westermann 2022.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mean of five pixels along the dominant displacement, 2^octave px apart, weighted by luminance and variance",
  fails  = "Adds bias: where motions differ, everything is blurred along the longest one. Textures and silhouettes along it "
    .. "are blurred if their contrast is within the noise. Noise over longer distances than the levels cover remains.",
  breaks = { linear = "weights depend on differences of luminance, and so on the light" },
  size   = { of = "noisy" },
  reads  = {
    noisy    = { doc = "noisy image of the previous level, linear radiance" },
    variance = { doc = "variance of luminance / (1 + luminance) in the previous level" },
    dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  },
  writes = {
    blurred = { format = "rgba32f", doc = "filtered image, linear radiance; alpha 1" },
    less    = { format = "r32f", doc = "remaining variance of luminance / (1 + luminance)" },
  },
  if_no = { motion = { blurred = "noisy", less = "variance" } },
  params = {
    tile  = blur.tile,
    octave = pass.int { 0, min = 0, max = 8, doc = "level of the filter; the five pixels of a level are 2^octave px apart" },
    deviations = pass.float { 4, min = 1e-3, max = 1024,
      doc = "luminance tolerance of the weights, in standard deviations; larger values remove more noise and more detail" },
  },
}
