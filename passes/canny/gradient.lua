-- SPDX-License-Identifier: MIT
-- Gradients of the smoothed depth and normal; first step of the edge detector canny. Canny 1986.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "canny_gradient",
  shader = "canny/gradient",
  doc    = "Steepest change of depth and normal after a Gaussian of 1 px",
  fails  = "What is closer together than about 3 px becomes one; corners become round.",
  size   = { of = "depth" },
  reads  = {
    depth  = { doc = "linear view depth, metres, sky = +inf" },
    normal = { doc = "unit, world space; sky = 0" },
  },
  writes = { gradient = { format = "rg32f", doc = "along the steepest direction; length 1 at the threshold" } },
  params = edge_ports.steps(),
}
