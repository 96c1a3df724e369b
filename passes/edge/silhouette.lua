-- SPDX-License-Identifier: MIT
-- Silhouettes between instances that stand off the plane of what is in front.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_silhouette",
  shader = "edge/silhouette",
  doc    = "Pixels beside another instance that is farther and off their own plane",
  fails  = "Blind to self-occlusion of one instance, and to what lies behind in the same plane. What rests on " ..
           "something has no silhouette where they touch, which is right only while neither moves.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "id", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  scene  = true,
  params = {
    depth_threshold = edge_ports.depth_threshold(0.02, "distance from the plane, as a share of the depth, of an edge"),
    measure         = edge_ports.measure(),
  },
}
