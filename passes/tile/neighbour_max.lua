-- SPDX-License-Identifier: MIT
-- The longest displacement that can reach each tile. McGuire et al. 2012, section 2.2; off-axis rule: Guertin et al.
-- 2014.
local pass = require "strobe.pass"

return pass.compute {
  name   = "neighbour_max",
  shader = "tile/neighbour_max",
  doc    = "Longest displacement among the tiles around that can reach each tile within the exposure",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "px over the exposure, longest of each tile" },
    motions = { optional = true, doc = "two displacements that stand for all in a tile, px over the exposure" },
  },
  writes = {
    dominant = { format = "rg32f", doc = "px over the exposure" },
    second   = { format = "rg32f", doc = "what differs most from it, px over the exposure; dominant if nothing does" },
  },
  params = {
    tile  = pass.int { 40, min = 1, max = 1024, unit = "px", doc = "side of a tile" },
    limit = pass.float { 0.1, min = 0, max = 10, unit = "image widths", doc = "longest displacement filters handle" },
    rule  = pass.choice { "reach", "all", default = "reach",
      doc = "reach: only tiles that move over this one within the exposure; all: every tile in range (McGuire 2012)" },
  },
}
