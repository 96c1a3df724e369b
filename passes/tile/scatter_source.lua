-- SPDX-License-Identifier: MIT
-- Scatter of displacements along themselves, as Unity's HDRP does it: from which tile the longest comes.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "scatter_source",
  shader = "tile/scatter_source",
  doc    = "Tile that the longest displacement is from whose tile comes over each tile within the exposure",
  fails  = "Of displacements equally long that cross at a tile those from one tile stand for all.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "px over the exposure, longest of each tile" },
    length  = { uint = true, doc = "of the longest that comes to each tile, of scatter_length" },
  },
  updates = { source = { format = "r32ui",
    doc = "number of tiles less that of the tile in raster order; 0: none" } },
  params = { tile = blur.tile },
}
