-- SPDX-License-Identifier: MIT
-- Edge detector by depth alone. Its place in passes/edge makes it a choice of the parameter `edge` of the hybrid:
--   strobe render hybrid --set edge=depth_step -o out/edges.png
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Pixels beside a pixel that is farther by more than the threshold",
  fails  = "Marks planes at grazing angles, where the next row is farther than the threshold.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth"),
  writes = { edge = edge_ports.edge },
  if_no  = edge_ports.nowhere,
  params = { depth_threshold = edge_ports.depth_threshold(0.1) },
}
