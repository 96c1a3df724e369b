-- SPDX-License-Identifier: MIT
-- Two displacements that stand for all in a tile; first step of the relative mask.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_tile_motions",
  shader = "mask/tile_motions",
  doc    = "The longest displacement of each tile and the one that differs most from it",
  fails  = "The third of three movements in a tile is lost.",
  size   = { of = "velocity", divide = "tile" },
  reads  = { velocity = { doc = "px over the exposure" } },
  writes = { motions = { format = "rgba32f", doc = "two displacements, px over the exposure" } },
  params = {
    tile  = pass.int { 40, min = 1, max = 1024, unit = "px", doc = "side of a tile" },
    limit = pass.float { 0.1, min = 0, max = 10, unit = "image widths", doc = "longest displacement handled" },
  },
}
