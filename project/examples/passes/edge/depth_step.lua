-- SPDX-License-Identifier: MIT
-- Edge detector that compares depths only. The files in passes/edge are the choices of the parameter `edge` of the pipeline
-- hybrid:
--   strobe render hybrid --set edge=depth_step -o out/edges.png
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edge mask: pixels beside a pixel that is farther by more than the depth threshold",
  fails  = "Marks planes at grazing angles, where the next row of pixels is farther by more than the threshold.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth"),
  writes = { edge = edge_ports.edge },
  if_no  = edge_ports.nowhere,
  params = { depth_threshold = edge_ports.depth_threshold(0.1) },
}
