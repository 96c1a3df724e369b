-- SPDX-License-Identifier: MIT
-- Edges where a surface leaves the tangent plane at a pixel, or where the normal changes abruptly.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges where a neighbouring pixel is off the tangent plane of the pixel's surface, or where the normal changes " ..
           "abruptly",
  fails  = "Misses an edge if the farther surface lies in the plane of the nearer one. With measure = second_difference, " ..
           "misses an edge pixel if one neighbour is nearer by as much as the opposite neighbour is farther. Coarsely " ..
           "quantised depths produce false edges.",
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
