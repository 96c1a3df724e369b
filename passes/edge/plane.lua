-- SPDX-License-Identifier: MIT
-- Edges where a surface leaves its tangent plane or its normal changes abruptly.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges where neighbouring pixels are off the plane of the surface, or the normal changes abruptly",
  fails  = "Misses farther surfaces that lie in the same plane. With measure = second_difference, misses pixels " ..
           "if one neighbour is as much nearer as the opposite one is farther. Coarsely quantised depths produce false edges.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  scene  = true,
  params = edge_ports.steps {
    depth_threshold = edge_ports.depth_threshold(0.02, "smallest distance from the plane at an edge, divided by the depth"),
    measure         = edge_ports.measure(),
  },
}
