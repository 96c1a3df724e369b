-- SPDX-License-Identifier: MIT
-- Gradients of the smoothed depth and normal; first step of the edge detector `canny`. Canny 1986.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Gradient of depth and normal after smoothing by a Gaussian with a standard deviation of 1 px",
  fails  = "Edges closer together than about 3 px merge; corners become round.",
  size   = { of = "depth" },
  reads  = {
    depth  = { doc = "linear view depth, metres; +inf for the sky" },
    normal = { doc = "unit normal, world space; 0 for the sky" },
  },
  writes = { gradient = { format = "rg32f",
    doc = "vector in the direction of the steepest change of depth and normal; its length is the strength of the edge, " ..
          "where 1 is the threshold" } },
  params = edge_ports.steps(),
}
