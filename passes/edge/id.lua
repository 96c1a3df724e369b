-- SPDX-License-Identifier: MIT
-- Silhouettes between instances, one pixel wide, on the nearer side.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Pixels beside a farther pixel of another instance",
  fails  = "Misses self-occlusion of one instance. Also marks lines where static parts touch or intersect: the " ..
           "rays there cost time, but cause no error.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "id"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
}
