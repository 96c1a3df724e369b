-- SPDX-License-Identifier: MIT
-- Distinct displacements around each tile, as candidates for the motion of hidden background; second step of the disocclusion
-- mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

local function pair(doc) return { format = "rgba32f", doc = doc } end

return pass.compute {
  doc    = "Up to eight distinct displacements around each tile, nearest tiles first: candidates for the displacement of " ..
           "background that is hidden in the tile",
  fails  = "If there are more than eight motions near a tile, the motions of the farthest tiles are lost; among equally far " ..
           "tiles, the motions of the last tiles in raster order.",
  size  = { of = "velocities" },
  reads = {
    velocities       = { doc = "two displacements that represent each tile, px over the exposure" },
    farthest         = { doc = "linear view depth of the farthest moving surface in each tile, metres; 0 for none" },
    max_displacement = max_displacement,
  },
  writes = {
    candidates_0 = pair "first and second displacement, px over the exposure; 1e9 for none",
    candidates_1 = pair "third and fourth displacement, px over the exposure; 1e9 for none",
    candidates_2 = pair "fifth and sixth displacement, px over the exposure; 1e9 for none",
    candidates_3 = pair "seventh and eighth displacement, px over the exposure; 1e9 for none",
    farthest_around = { format = "r32f",
      doc = "linear view depth of the farthest visible moving surface around each tile, metres; 0 for none" },
  },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
