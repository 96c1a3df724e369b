-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal, with equal weights perpendicular to the gradient. Prewitt 1970.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges from gradients of depth and normal, by Prewitt's kernel: equal weights perpendicular to the gradient",
  fails  = "Marks planes at grazing angles and curved surfaces, although they are not edges. The response depends more on " ..
           "direction than with `sobel`: for waves with a length of 7 px it is 7 % smaller along a diagonal than along an " ..
           "axis.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
