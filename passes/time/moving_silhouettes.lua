-- SPDX-License-Identifier: MIT
-- Texels beside a moving silhouette, where a sample between texels may fall on either side.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Texels with a neighbour of different motion, so that a moving silhouette may lie between the two texels",
  fails  = "Misses objects narrower than a pixel that lie between texel centres.",
  size   = { of = "velocity" },
  reads  = {
    velocity      = { doc = "screen displacement of the surface, px over the exposure" },
    velocity_post = { absent = "velocity",
      doc = "screen displacement of the surface after the raster time, scaled to the whole exposure, px" },
  },
  writes = { near = { format = "r8_unorm", cleared = true, doc = "mask, 1 at texels with a neighbour of different motion, " ..
      "otherwise 0" } },
  params = {
    slowest = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "smallest difference of displacements that counts as different motion. For fast motion the threshold rises to 5 " ..
            "% of the shorter displacement, up to 1/2 px" },
  },
  if_no = { motion = { near = 0 }, moving_rect = { near = 0 } },
}
