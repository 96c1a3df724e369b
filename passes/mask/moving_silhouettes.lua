-- SPDX-License-Identifier: MIT
-- Where a sample between pixels may fall to either side of an edge that moves.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_moving_silhouettes",
  shader = "mask/moving_silhouettes",
  doc    = "Texels of which one around moves otherwise: between them lies a silhouette",
  fails  = "What is narrower than a pixel and lies between texels is not there.",
  size   = { of = "velocity" },
  reads  = {
    velocity       = { doc = "px over the exposure" },
    after_velocity = { optional = true, doc = "px over the exposure, at times after the capture" },
  },
  writes = { near = { format = "r8_unorm", cleared = true, doc = "1 next to something that moves otherwise" } },
  params = {
    slowest = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "least difference of displacements that counts, of what moves slowly" },
  },
  without = { motion = { near = 0 }, reached = { near = 0 } },
}
