-- SPDX-License-Identifier: MIT
-- Edges where a surface leaves its plane or its normal steps.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_plane",
  shader = "edge/plane",
  doc    = "Edges where a surface leaves the plane it is on, or its normal steps",
  fails  = "Surfaces behind that lie on the same plane are missed, and by second differences pixels whose two " ..
           "neighbours are as much nearer as farther; depths of few bits make edges of their own.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  scene  = true,
  params = edge_ports.steps {
    depth_threshold = edge_ports.depth_threshold(0.02, "distance from the plane, as a share of the depth, of an edge"),
    measure         = edge_ports.measure(),
  },
}
