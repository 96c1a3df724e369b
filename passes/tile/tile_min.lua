-- SPDX-License-Identifier: MIT
-- Length of the shortest displacement of each tile. Guertin et al. 2014; Jimenez 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Length of the shortest displacement of each tile",
  fails  = "Directions are not compared: a rotating tile counts as uniform, like a tile that moves along a line.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "displacement of the surface, px over the exposure" },
    valid    = { absent = 1, doc = "mask, above 1/2 at texels that the minimum includes" },
  },
  writes = { shortest = { format = "r32f",
    doc = "length of the shortest displacement, px over the exposure; the displacement limit if no texel is included" } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
