-- SPDX-License-Identifier: MIT
-- Thin edges by hysteresis, last of three steps. Canny 1986.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  name   = "edge_canny",
  shader = "edge/canny",
  doc    = "Thin edges: strong ridges of the smoothed gradient, and weak ones connected to them",
  fails  = "Edges are one pixel wide, so a range check with steps of more than a pixel misses them. A weak part of " ..
           "an edge is kept only up to `reach` pixels along x or y from a strong one. What is closer together than " ..
           "about 3 px becomes one edge; planes at grazing angles can have ridges.",
  size   = { of = "ridge" },
  reads  = {
    ridge = { doc = "1 strong, 1/2 weak, 0 none" },
    where = { optional = true, doc = "above 1/2 where to mark; absent: everywhere" },
  },
  writes = { edge = edge_ports.edge },
  without = edge_ports.nowhere,
  params = {
    reach = pass.int { 15, min = 0, max = 15, unit = "px", doc = "how far from a strong edge a weak one may be" },
  },
}
