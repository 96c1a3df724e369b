-- SPDX-License-Identifier: MIT
-- Thin edges by hysteresis; last of three steps of the edge detector `canny`. Canny 1986.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Thin edges: strong ridges of the smoothed gradient, and weak ridges connected to strong ones",
  fails  = "Edges are one pixel wide: the pass `range_check` misses them with steps of more than a pixel. A weak part of " ..
           "an edge is kept only up to `reach` pixels along x or y from a strong part. Edges closer together than " ..
           "about 3 px merge. Planes at grazing angles can have ridges.",
  size   = { of = "ridge" },
  reads  = {
    ridge = { doc = "class of the ridge: 1 strong, 1/2 weak, 0 none" },
    where = { absent = 1, doc = "mask, above 1/2 where edges are marked" },
  },
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = {
    reach = pass.int { 15, min = 0, max = 15, unit = "px", doc = "largest distance between a weak and a strong ridge" },
  },
}
