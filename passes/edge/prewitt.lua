-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal with equal weights across. Prewitt 1970.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_prewitt",
  shader = "edge/prewitt",
  doc    = "As sobel, with equal weights across the gradient",
  fails  = "Planes at grazing angles and curved surfaces are marked, as with sobel. Its answer depends on direction " ..
           "more: of a wave of 7 px it is 7 % less along a diagonal.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
