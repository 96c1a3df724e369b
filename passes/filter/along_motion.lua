-- SPDX-License-Identifier: MIT
-- One level of a wavelet filter along the motion, guided by variance. Oberberger, Chajdas, Westermann 2022.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Weighted mean of five pixels, 2^octave px apart along the dominant displacement. The weight of a pixel " ..
           "falls with the difference of its luminance from the middle pixel, relative to the standard deviation of " ..
           "the noise",
  fails  = "Adds bias: where several motions meet, all surfaces are blurred along the longest displacement. " ..
           "Textures and silhouettes along this displacement are blurred if their contrast is within the noise. " ..
           "Noise in patches longer than the widest filter level remains.",
  breaks = { linear = "weights depend on differences of luminance, so brighter light changes the weights" },
  size   = { of = "noisy" },
  reads  = {
    noisy    = { doc = "noisy image, or the output of the previous filter level, linear radiance" },
    variance = { doc = "variance of the tone, which is luminance / (1 + luminance), in the noisy image or after the " ..
                       "previous filter level" },
    dominant = { doc = "longest displacement that can bring a surface to each tile, px over the exposure" },
  },
  writes = {
    blurred = { format = "rgba32f", doc = "filtered image, linear radiance; alpha 1" },
    less    = { format = "r32f", doc = "variance of the tone, which is luminance / (1 + luminance), that remains " ..
                                       "after this filter level" },
  },
  if_no = { motion = { blurred = "noisy", less = "variance" } },
  params = {
    tile  = blur.tile,
    octave = pass.int { 0, min = 0, max = 8, doc = "level of the filter; the five pixels of a level are 2^octave px apart" },
    deviations = pass.float { 4, min = 1e-3, max = 1024,
      doc = "luminance tolerance of the weights, in standard deviations; larger values remove more noise and more detail" },
  },
}
