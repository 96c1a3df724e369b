-- SPDX-License-Identifier: MIT
-- Ridges one pixel wide, strong and weak; second step of the edge detector `canny`. Canny 1986.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Ridges of the gradient, one pixel wide (non-maximum suppression): pixels whose gradient exceeds the gradients " ..
           "of both neighbours across the edge",
  fails  = "At a junction of three edges, one edge may end a pixel early.",
  breaks = { mirrored = "of two neighbouring pixels with equally strong gradients, the right or lower one is removed; in a " ..
                       "mirrored scene this is the other pixel" },
  size   = { of = "gradient" },
  reads  = { gradient = {
    doc = "vector in the direction of the steepest change of depth and normal; its length is the strength of the edge, " ..
          "where 1 is the threshold" } },
  writes = { ridge = { format = "r8_unorm", doc = "class of each pixel: 1 on a strong ridge of the gradient, 1/2 on a weak " ..
      "ridge, 0 elsewhere" } },
  params = {
    ratio = pass.float { 2, min = 1, max = 100, doc = "threshold of strong edges, divided by the threshold of weak edges" },
  },
}
