-- SPDX-License-Identifier: MIT
-- The length of the shortest displacement of each tile. Guertin et al. 2014; Jimenez 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "tile_min",
  shader = "tile/tile_min",
  doc    = "Length of the shortest displacement of each tile",
  fails  = "Directions are not compared: a turning tile looks as uniform as one that slides.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "px over the exposure" },
    valid    = { optional = true, doc = "above 1/2 where velocity counts; absent: everywhere" },
  },
  writes = { shortest = { format = "r32f", doc = "px over the exposure; a tile where nothing counts has the limit" } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
