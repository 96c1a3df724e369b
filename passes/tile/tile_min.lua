-- SPDX-License-Identifier: MIT
-- Length of the shortest displacement of each tile. Guertin et al. 2014; Jimenez 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Length of the shortest displacement in each tile",
  fails  = "Only lengths are compared: a tile with rotating motion counts as uniform, like a tile that moves along a line.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
    valid    = { absent = 1, doc = "mask, above 1/2 at texels that the minimum includes" },
  },
  writes = { shortest = { format = "r32f",
    doc = "length of the shortest displacement in each tile, px over the exposure; equal to the displacement limit if no " ..
          "texel is included" } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
