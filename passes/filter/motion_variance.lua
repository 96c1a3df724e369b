-- SPDX-License-Identifier: MIT
-- Noise of an image with one time sample per pixel, estimated along the motion. Oberberger, Chajdas, Westermann 2022.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Variance of the tone, a compressed luminance, along the dominant displacement; 0 where no pixel within " ..
           "8 px along this displacement hits a moving surface",
  fails  = "A texture that varies along the motion is treated as noise.",
  size   = { of = "noisy" },
  reads  = {
    noisy    = { doc = "image with one time sample per pixel, linear radiance" },
    moved    = { doc = "screen displacement of the surface hit at the pixel's time, px over the exposure" },
    dominant = { doc = "longest displacement that can bring a surface to each tile, px over the exposure" },
  },
  writes = { variance = { format = "r32f", doc = "variance of the tone, which is luminance / (1 + luminance)" } },
  if_no = { motion = { variance = 0 } },
  params = { tile = blur.tile },
}
