-- SPDX-License-Identifier: MIT
-- Silhouettes between instances, one pixel wide, on the nearer side.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Silhouettes between instances: pixels beside a farther pixel of another instance",
  fails  = "Misses silhouettes between two parts of one instance (self-occlusion). Also marks lines where static objects " ..
           "touch or intersect; rays that are traced there cost time, but cause no error.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "id"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
}
