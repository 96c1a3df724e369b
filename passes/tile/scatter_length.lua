-- SPDX-License-Identifier: MIT
-- Scatter of displacements along themselves, as Unity's HDRP does it: how long the longest is that comes to a tile.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "scatter_length",
  shader = "tile/scatter_length",
  doc    = "Length of the longest displacement whose tile comes over each tile within the exposure",
  fails  = "A tile is judged by its longest displacement, and its way is the line of its centre: two that cross in it are one.",
  size   = { of = "longest" },
  reads  = { longest = { doc = "px over the exposure, longest of each tile" } },
  updates = { length = { format = "r32ui", doc = "px over the exposure, the bits of a float; 0: nothing" } },
  params = { tile = blur.tile },
}
