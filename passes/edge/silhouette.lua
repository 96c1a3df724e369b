-- SPDX-License-Identifier: MIT
-- Silhouettes between instances, without contacts: the farther surface must be off the plane of the nearer one.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Silhouettes between instances that do not touch: pixels beside a farther pixel of another instance, if this " ..
           "farther pixel is off the tangent plane of the nearer surface",
  fails  = "Misses silhouettes between two parts of one instance (self-occlusion), and in front of a background in the same " ..
           "plane. An object that rests on another one has no silhouette at the contact, which is right only while neither " ..
           "of the two moves.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "id", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  scene  = true,
  params = {
    depth_threshold = edge_ports.depth_threshold(0.02, "smallest distance from the plane at an edge, divided by the depth"),
    measure         = edge_ports.measure(),
  },
}
