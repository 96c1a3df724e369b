-- SPDX-License-Identifier: MIT
-- One level of a wavelet filter along the motion, guided by variance. Oberberger, Chajdas, Westermann 2022.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "along_motion",
  shader = "filter/along_motion",
  doc    = "Five pixels along the motion around, 2^octave apart, weighed by how their luminance fits the variance",
  fails  = "By bias: where motions differ all are blurred along the longest, and textures and silhouettes along it as far as "
    .. "they pass for noise. What the levels do not reach stays noisy.",
  breaks = { linear = "luminances are compared: other light has other weights" },
  size   = { of = "noisy" },
  reads  = {
    noisy    = { doc = "linear, of the level before" },
    variance = { doc = "of luminance / (1 + luminance), of the level before" },
    dominant = { doc = "px over the exposure, per tile" },
  },
  writes = {
    blurred = { format = "rgba32f", doc = "linear; alpha 1" },
    less    = { format = "r32f", doc = "variance that is left" },
  },
  without = { motion = { blurred = "noisy", less = "variance" } },
  params = {
    tile  = blur.tile,
    octave = pass.int { 0, min = 0, max = 8, doc = "pixels lie 2^octave apart" },
    deviations = pass.float { 4, min = 1e-3, max = 1024,
      doc = "standard deviations by which a pixel may differ: more takes away more noise, and more of the picture" },
  },
}
