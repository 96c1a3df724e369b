-- SPDX-License-Identifier: MIT
-- Texels beside a moving silhouette, where a sample between texels may fall on either side.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Texels beside a texel with different motion, so that a silhouette lies between them",
  fails  = "Misses objects narrower than a pixel that lie between texel centres.",
  size   = { of = "velocity" },
  reads  = {
    velocity      = { doc = "displacement of the surface, px over the exposure" },
    velocity_post = { absent = "velocity",
      doc = "displacement of the surface at times after the raster time, px over the exposure" },
  },
  writes = { near = { format = "r8_unorm", cleared = true, doc = "mask, 1 beside a texel with different motion" } },
  params = {
    slowest = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "smallest difference of displacements that counts as different motion. If 5 % of the shorter displacement is " ..
            "larger, that value is the threshold, up to 1/2 px" },
  },
  if_no = { motion = { near = 0 }, moving_rect = { near = 0 } },
}
