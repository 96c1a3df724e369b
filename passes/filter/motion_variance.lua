-- SPDX-License-Identifier: MIT
-- How noisy one time per pixel leaves a picture, told from the pixels along the motion. Oberberger, Chajdas, Westermann 2022.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "motion_variance",
  shader = "filter/motion_variance",
  doc    = "Variance of the luminance along the motion around, 0 where no pixel on it sees anything that moves",
  fails  = "A texture that lies along the motion is taken for noise.",
  size   = { of = "noisy" },
  reads  = {
    noisy    = { doc = "linear, of one time per pixel" },
    moved    = { doc = "px over the exposure, of what is seen at that time" },
    dominant = { doc = "px over the exposure, per tile" },
  },
  writes = { variance = { format = "r32f", doc = "of luminance / (1 + luminance)" } },
  without = { motion = { variance = 0 } },
  params = { tile = blur.tile },
}
