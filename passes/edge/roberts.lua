-- SPDX-License-Identifier: MIT
-- Edges from differences of depth and normal along two diagonals. Roberts 1963.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges from two diagonal differences of 2 x 2 pixels, one pixel wide",
  fails  = "The response is centred half a pixel to the right and below. Silhouettes with the nearer side to the right or " ..
           "below are marked on the farther pixel, where the ray mask does not search. Objects that move left or " ..
           "up therefore get no mask. Marks planes at grazing angles, as `sobel` does.",
  breaks = { mirrored = "a block of 2 x 2 pixels has no centre pixel" },
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
