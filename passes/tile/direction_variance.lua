-- SPDX-License-Identifier: MIT
-- Variance of the motion directions around each tile. Guertin et al. 2014.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Variance of the motion directions around each tile: 1 minus the mean absolute cosine between the " ..
           "direction of the tile and the directions of the 3 x 3 tiles around it",
  fails  = "Each tile is represented by one displacement: motions that cross within a tile are missed.",
  size   = { of = "longest" },
  reads  = {
    longest  = { doc = "longest displacement in each tile, px over the exposure" },
    dominant = { doc = "longest displacement that can bring a surface to each tile, px over the exposure; its direction is " ..
                       "used for static tiles" },
  },
  writes = { variance = { format = "r32f", doc = "variance of the motion directions, 0 (all parallel to the tile's " ..
      "direction) to 1 (all perpendicular to this direction)" } },
  if_no = { motion = { variance = 0 } },
}
