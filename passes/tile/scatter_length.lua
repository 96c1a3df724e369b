-- SPDX-License-Identifier: MIT
-- Scatter of tile displacements along their motion, as in Unity's HDRP: length of the longest displacement that
-- arrives at each tile.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Length of the longest displacement that passes over each tile within the exposure",
  fails  = "A tile is represented by its longest displacement, and its path by the line of its centre: of two motions that " ..
           "cross in a tile, one is lost.",
  size   = { of = "longest" },
  reads  = { longest = { doc = "longest displacement of each tile, px over the exposure" } },
  updates = { length = { format = "r32ui",
    doc = "length of the longest displacement as the bits of a float, px over the exposure; 0 for none" } },
  params = { tile = blur.tile },
}
