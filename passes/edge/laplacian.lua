-- SPDX-License-Identifier: MIT
-- Edges from second differences of inverse depth and normal. Marr and Hildreth 1980.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_laplacian",
  shader = "edge/laplacian",
  doc    = "Edges where the second difference of inverse depth or of the normal is large",
  fails  = "It answers on both sides of a step, and to noise more than gradients do. A step is that of 1/z, 1 - " ..
           "near / far, less than the depth step of the gradients where the gap is large.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = edge_ports.steps {
    kernel = pass.choice { "four", "eight", "log", default = "four", doc = "neighbours that count, and how",
      values = {
        four  = "The four neighbours. Fails to treat directions alike: a diagonal step answers twice as much as one " ..
                "along an axis.",
        eight = "All eight neighbours, alike. A diagonal step answers as one along an axis; noise counts as with four.",
        log   = "The Laplacian of a Gaussian of standard deviation 1 px. Fails to tell apart what is closer than " ..
                "about 3 px; edges are four pixels wide.",
      } },
  },
}
