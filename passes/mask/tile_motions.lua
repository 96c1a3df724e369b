-- SPDX-License-Identifier: MIT
-- Two displacements that stand for all in a tile; first step of the relative mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_tile_motions",
  shader = "mask/tile_motions",
  doc    = "The longest displacement of each tile and the one that differs most from it",
  fails  = "The third of three movements in a tile is lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "px over the exposure" },
    depth    = { doc = "linear view depth, metres, sky = +inf" },
  },
  writes = {
    motions  = { format = "rgba32f", doc = "two displacements, px over the exposure" },
    farthest = { format = "r32f", doc = "depth of the farthest that moves, metres; 0 where nothing does" },
  },
  without = { motion = { motions = 0, farthest = 0 }, reached = { motions = 0, farthest = 0 } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
