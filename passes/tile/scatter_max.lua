-- SPDX-License-Identifier: MIT
-- Longest displacement scattered to a tile or its neighbours, as in Unity's HDRP.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Longest displacement scattered to each tile or its eight neighbours",
  fails  = "One displacement represents all displacements that reach a tile: crossing motions are lost. A displacement also " ..
           "dominates one tile beyond its end.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "longest displacement of each tile, px over the exposure" },
    source  = { uint = true, doc = "tile of origin of the longest displacement that reaches each tile, from `scatter_source`" },
  },
  writes = { dominant = { format = "rg32f", doc = "longest displacement that reaches each tile, px over the exposure" } },
  if_no = { motion = { dominant = 0 } },
}
