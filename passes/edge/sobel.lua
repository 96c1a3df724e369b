-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal. Tan, Cui and Bhojan 2020, section "Ray Mask".
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges from gradients of depth and normal, by Sobel's kernel",
  fails  = "Marks whole planes at grazing angles, such as floors, because their depth gradient is as large as at an edge. " ..
           "Also marks curved surfaces at grazing angles. Edges are two pixels wide.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
