-- SPDX-License-Identifier: MIT
-- Two displacements that represent each tile; first step of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_tile_motions",
  shader = "mask/tile_motions",
  doc    = "Longest displacement of each tile, and the displacement that differs most from it",
  fails  = "The third of three motions in a tile is lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "displacement of the surface, px over the exposure" },
    depth    = { doc = "linear view depth, metres; +inf for the sky" },
  },
  writes = {
    motions  = { format = "rgba32f", doc = "longest displacement and the displacement farthest from it, px over the exposure" },
    farthest = { format = "r32f", doc = "linear view depth of the farthest moving surface, metres; 0 for none" },
  },
  without = { motion = { motions = 0, farthest = 0 }, reached = { motions = 0, farthest = 0 } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
