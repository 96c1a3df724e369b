-- SPDX-License-Identifier: MIT
-- Hysteresis: strong ridges of the gradient, and weak ridges connected to strong ones; last of three steps of the edge detector
-- `canny`. Canny 1986.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges one pixel wide: strong ridges of the gradient of depth and normal, and weak ridges connected to strong ones",
  fails  = "Edges are one pixel wide. The pass `range_check`, which searches for an edge along the motion, therefore misses " ..
           "edges if its steps are longer than a pixel. The weak part of an edge is kept only up to `reach` pixels along x " ..
           "or y from a strong part. Edges closer together than about 3 px merge. Planes at grazing angles may be marked as " ..
           "edges.",
  size   = { of = "ridge" },
  reads  = {
    ridge = { doc = "class of each pixel: 1 on a strong ridge of the gradient, 1/2 on a weak ridge, 0 elsewhere" },
    where = { absent = 1, doc = "mask, above 1/2 at pixels that may be marked as edges" },
  },
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = {
    reach = pass.int { 15, min = 0, max = 15, unit = "px", doc = "largest distance, along x or y, of a weak ridge from the " ..
        "strong ridge that it is connected to" },
  },
}
