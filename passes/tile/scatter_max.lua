-- SPDX-License-Identifier: MIT
-- The longest displacement that was scattered to a tile or beside it, as Unity's HDRP does it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "scatter_max",
  shader = "tile/scatter_max",
  doc    = "Longest displacement that came to a tile or to one beside it",
  fails  = "One displacement stands for all that come: what crosses it is lost, and it dominates a tile farther than it comes.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "px over the exposure, longest of each tile" },
    source  = { uint = true, doc = "tile that the longest comes from, of scatter_source" },
  },
  writes = { dominant = { format = "rg32f", doc = "px over the exposure" } },
  without = { motion = { dominant = 0 } },
}
