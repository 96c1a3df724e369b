-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal. Tan, Cui and Bhojan 2020, Ray Mask.
local pass = require "strobe.pass"

return pass.compute {
  name   = "edge_sobel",
  shader = "edge/sobel",
  doc    = "Edges where depth or normal change from pixel to pixel",
  size   = { of = "depth" },
  reads  = {
    depth  = { doc = "linear view depth, metres, sky = +inf" },
    normal = { doc = "unit, world space; sky = 0" },
    where  = { optional = true, doc = "above 1/2 where to look; absent: everywhere" },
  },
  writes = { edge = { format = "r8_unorm", doc = "1 on an edge" } },
  params = {
    depth_threshold  = pass.float { 0.05, min = 1e-6, max = 16, doc = "relative depth step of an edge" },
    normal_threshold = pass.float { 0.8, min = 1e-6, max = 4, doc = "length of the normal step of an edge" },
    combine          = pass.choice { "max", "sum", "and", default = "max",
      doc = "either, both added, or both at once" },
    norm             = pass.choice { "l1", "l2", default = "l2", doc = "how the gradients along x and y are combined" },
  },
}
