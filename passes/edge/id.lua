-- SPDX-License-Identifier: MIT
-- Silhouettes between instances, on their nearer side.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_id",
  shader = "edge/id",
  doc    = "Pixels beside another instance that is farther",
  fails  = "Blind to self-occlusion of one instance. Where resting parts touch or intersect it marks the contact " ..
           "too, which costs rays but is no error.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "id"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
}
