-- SPDX-License-Identifier: MIT
-- The distinct displacements around each tile; second step of the relative mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

local function pair(doc) return { format = "rgba32f", doc = doc } end

return pass.compute {
  name   = "mask_near_motions",
  shader = "mask/near_motions",
  doc    = "Up to eight distinct displacements around each tile, nearest first",
  fails  = "Of more than eight movements near a tile the far ones are lost, and of those equally far the last in " ..
           "raster order.",
  size   = { of = "motions" },
  reads  = {
    motions  = { doc = "two displacements per tile, px over the exposure" },
    farthest = { doc = "depth of the farthest that moves in each tile, metres; 0 = none" },
    reach    = reach,
  },
  writes = {
    motions_0 = pair "first and second displacement, px over the exposure; 1e9 = none",
    motions_1 = pair "third and fourth",
    motions_2 = pair "fifth and sixth",
    motions_3 = pair "seventh and eighth",
    farthest_around = { format = "r32f", doc = "depth of the farthest that moves around each tile, metres; 0 = none" },
  },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
