-- SPDX-License-Identifier: MIT
-- Edges from differences of depth and normal along two diagonals. Roberts 1963.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges, one pixel wide, from the differences of depth and normal along the two diagonals of 2 x 2 pixels",
  fails  = "The left and the upper silhouette of an object are marked on the farther surface, because a step is marked on " ..
           "the pixel to its left or above it. The pass `range_check` ignores these marks: by default it requires an edge " ..
           "on the object itself. If the exposure ends at the raster time (anchor `end`), the ray mask therefore misses " ..
           "objects that move left or up. Planes at grazing angles and curved surfaces are marked, although they are not " ..
           "edges.",
  breaks = { mirrored = "an edge is marked half a pixel to the left of and above its position, in a mirrored scene too" },
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
