-- SPDX-License-Identifier: MIT
-- Ridges one pixel wide, strong and weak; second step of the edge detector canny. Canny 1986.
local pass = require "strobe.pass"

return pass.compute {
  name   = "canny_thin",
  shader = "canny/thin",
  doc    = "Pixels whose gradient exceeds that of both neighbours across the edge",
  fails  = "Where three edges meet, one may be cut off a pixel before the others.",
  breaks = { mirrored = "of two neighbours that answer alike the right or lower one is no edge" },
  size   = { of = "gradient" },
  reads  = { gradient = { doc = "along the steepest direction; length 1 at the threshold" } },
  writes = { ridge = { format = "r8_unorm", doc = "1 strong, 1/2 weak, 0 none" } },
  params = {
    ratio = pass.float { 2, min = 1, max = 100, doc = "threshold of strong edges, as a multiple of that of weak ones" },
  },
}
