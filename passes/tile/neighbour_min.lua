-- SPDX-License-Identifier: MIT
-- The length of the shortest displacement around each tile. Guertin et al. 2014; Jimenez 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.compute {
  name   = "neighbour_min",
  shader = "tile/neighbour_min",
  doc    = "Length of the shortest displacement among the tiles around, whether it reaches this one or not",
  fails  = "One pixel at rest in range makes the whole neighbourhood slow.",
  size   = { of = "shortest" },
  reads  = { shortest = { doc = "px over the exposure, shortest of each tile" }, reach = reach },
  writes = { slowest = { format = "r32f", doc = "px over the exposure" } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
