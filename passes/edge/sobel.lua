-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal. Tan, Cui and Bhojan 2020, Ray Mask.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_sobel",
  shader = "edge/sobel",
  doc    = "Edges where depth or normal change from pixel to pixel",
  fails  = "On planes at grazing angles the depth changes from pixel to pixel as at an edge, so that whole floors " ..
           "are marked; curved surfaces seen at grazing angles are marked too. Edges are two pixels wide.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
