-- SPDX-License-Identifier: MIT
-- Edges from gradients of depth and normal, with the most isotropic weights. Scharr 2000.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges from gradients of depth and normal, by Scharr's kernel, whose response to smooth changes depends less on " ..
           "direction than with `sobel` and `prewitt`",
  fails  = "Marks planes at grazing angles and curved surfaces, although they are not edges. The response is independent of " ..
           "direction only for smooth changes: for a hard step along a diagonal it is 15 % larger than for a hard step " ..
           "along an axis.",
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
