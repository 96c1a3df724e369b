-- SPDX-License-Identifier: MIT
-- Scatter of tile displacements to all tiles on their paths, as in Unity's HDRP; last of three passes. This pass stores the
-- longest displacement that passes over each tile or one of its neighbours.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Dominant displacement of each tile: the longest displacement whose path passes over the tile or one of its " ..
           "eight neighbours",
  fails  = "One displacement represents all displacements that reach a tile: of motions that cross, all but the longest are " ..
           "lost. A displacement also dominates the tiles beside its path, and one tile beyond its end.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "longest displacement in each tile, px over the exposure" },
    source  = { uint = true, doc = "tile of origin of the longest displacement that passes over each tile, as encoded by " ..
                                   "`scatter_source`" },
  },
  writes = { dominant = { format = "rg32f", doc = "longest displacement that can bring a surface to each tile, px over the " ..
      "exposure" } },
  if_no = { motion = { dominant = 0 } },
}
