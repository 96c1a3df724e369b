-- SPDX-License-Identifier: MIT
-- Scatter of tile displacements along their motion, as in Unity's HDRP: origin of the longest displacement that
-- arrives at each tile.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Tile of origin of the longest displacement that passes over each tile within the exposure",
  fails  = "If equally long displacements cross at a tile, only the one from the first tile in raster order is kept.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "longest displacement of each tile, px over the exposure" },
    length  = { uint = true,
      doc = "length of the longest displacement that reaches each tile, bits of a float, from `scatter_length`" },
  },
  updates = { source = { format = "r32ui",
    doc = "number of tiles minus the raster index of the tile of origin; 0 for none" } },
  params = { tile = blur.tile },
}
