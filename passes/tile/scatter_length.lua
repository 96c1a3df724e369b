-- SPDX-License-Identifier: MIT
-- Scatter of tile displacements to all tiles on their paths, as in Unity's HDRP; first of three passes. This pass stores the
-- length of the longest displacement that passes over each tile.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "For each tile, length of the longest displacement that passes over the tile within the exposure",
  fails  = "Each tile is represented by its longest displacement: of two motions that cross in a tile, one is lost. The " ..
           "path of a tile is represented by the line of its centre.",
  size   = { of = "longest" },
  reads  = { longest = { doc = "longest displacement in each tile, px over the exposure" } },
  updates = { length = { format = "r32ui",
    doc = "length of the longest displacement that passes over each tile, px over the exposure, as the bits of a float; 0 " ..
          "for none" } },
  params = { tile = blur.tile },
}
