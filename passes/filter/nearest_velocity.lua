-- SPDX-License-Identifier: MIT
-- Displacement of the nearest surface around each pixel.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Displacement of the nearest surface in the 3x3 pixels around each pixel; moving silhouettes grow by a pixel",
  fails  = "A pixel beside a silhouette gets the displacement of the nearer surface, but keeps its own colour and depth.",
  size   = { of = "velocity" },
  reads  = {
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
    depth    = { doc = "linear view depth, metres; +inf for the sky" },
  },
  writes = { nearest = { format = "rg32f",
    doc = "screen displacement of the nearest surface of 3x3 pixels, px over the exposure" } },
  if_no  = { motion = { nearest = "velocity" }, moving_rect = { nearest = "velocity" } },
}
