-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal, least dependent on direction. Scharr 2000.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_scharr",
  shader = "edge/scharr",
  doc    = "As sobel, with the weights whose answer depends least on direction",
  fails  = "Planes at grazing angles and curved surfaces are marked, as with sobel. Its even answer is that of " ..
           "smooth changes: a hard step along a diagonal of the pixels answers 15 % more than one along an axis.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
