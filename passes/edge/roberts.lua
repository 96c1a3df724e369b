-- SPDX-License-Identifier: MIT
-- Edges from differences of depth and normal along two diagonals. Roberts 1963.
local pass       = require "strobe.pass"
local edge_ports = require "passes.lib.edge_ports"

return pass.compute {
  doc    = "Edges, one pixel wide, from the differences of depth and normal along the two diagonals of 2 x 2 pixels",
  fails  = "A step is marked on the pixel to its left or above it, even if this pixel is on the farther side. A " ..
           "silhouette whose nearer side is to the right or below is therefore marked on the farther side. The pass " ..
           "`range_check` ignores such a mark, because by default it requires an edge on the pixel's own instance. " ..
           "With the anchor `end`, the ray mask therefore misses objects that move left or up. Planes at grazing " ..
           "angles and curved surfaces are marked, although they are not edges.",
  breaks = { mirrored = "an edge is marked half a pixel to the left of and above its position, in a mirrored scene too" },
  size   = { of = "depth" },
  reads  = edge_ports.reads("depth", "normal"),
  writes = { edge = edge_ports.edge },
  if_no = edge_ports.nowhere,
  params = edge_ports.gradients(),
}
