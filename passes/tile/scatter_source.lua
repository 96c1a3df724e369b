-- SPDX-License-Identifier: MIT
-- Scatter of tile displacements to all tiles on their paths, as in Unity's HDRP; second of three passes. This pass stores the
-- tile of origin of the longest displacement that passes over each tile.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "For each tile, tile of origin of the longest displacement that passes over the tile within the exposure",
  fails  = "If equally long displacements cross at a tile, only the one from the first tile in raster order is kept.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "longest displacement in each tile, px over the exposure" },
    length  = { uint = true,
      doc = "length of the longest displacement that passes over each tile, px over the exposure, as the bits of a float, " ..
            "from `scatter_length`" },
  },
  updates = { source = { format = "r32ui",
    doc = "tile of origin, encoded as the number of all tiles minus the tile's index in raster order, so that an atomic " ..
          "maximum keeps the first tile; 0 for none" } },
  params = { tile = blur.tile },
}
