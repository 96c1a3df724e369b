-- SPDX-License-Identifier: MIT
-- Edges from second differences of inverse depth and normal. Marr and Hildreth 1980.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges where the second difference of inverse depth or of the normal is large",
  fails  = "Marks both sides of a step, and marks noise more often than gradient detectors do. A depth step counts " ..
           "as 1 - nearer depth / farther depth, so that it is at most 1 even where the gap is large. In gradient " ..
           "detectors, a large gap counts as a larger step.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.steps {
    kernel = pass.choice { "four", "eight", "log", default = "four", doc = "kernel that computes the second difference",
      values = {
        four  = "Sum over the four neighbours. Fails for diagonals: the response to a diagonal step is twice the response " ..
                "to a step along an axis. Also marks noise as edges.",
        eight = "Sum over all eight neighbours with equal weights, so that diagonal and axis-aligned steps have equal " ..
                "responses. Fails by marking noise as edges.",
        log   = "Laplacian of a Gaussian with a standard deviation of 1 px, which suppresses noise. Fails by merging edges " ..
                "closer than about 3 px; edges are four pixels wide.",
      } },
  },
}
