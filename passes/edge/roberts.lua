-- SPDX-License-Identifier: MIT
-- Edges from differences of depth and normal along two diagonals. Roberts 1963.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_roberts",
  shader = "edge/roberts",
  doc    = "Edges from two diagonal differences of 2 x 2 pixels, one pixel wide",
  fails  = "Its answer is half a pixel to the right and below. Silhouettes whose nearer side is to the right or " ..
           "below are marked on the farther pixel, where the mask seed does not look: objects that move left or up " ..
           "get no mask. Planes at grazing angles are marked, as with sobel.",
  breaks = { mirrored = "its two by two pixels have no middle pixel" },
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
