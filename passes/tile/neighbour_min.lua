-- SPDX-License-Identifier: MIT
-- Length of the shortest displacement around each tile. Guertin et al. 2014; Jimenez 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.compute {
  doc    = "Length of the shortest displacement around each tile, within the search radius of the filters; filters compare " ..
           "it with the dominant displacement to find uniform motion",
  fails  = "One static pixel within the search radius makes the motion of the whole neighbourhood count as not uniform. " ..
           "Tiles are included even if their motion does not reach this tile.",
  size   = { of = "shortest" },
  reads  = {
    shortest = { doc = "length of the shortest displacement in each tile, px over the exposure" },
    max_displacement = max_displacement,
  },
  writes = { slowest = { format = "r32f",
    doc = "length of the shortest displacement around each tile, px over the exposure" } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
