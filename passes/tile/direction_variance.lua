-- SPDX-License-Identifier: MIT
-- Variance of the motion directions around each tile. Guertin et al. 2014.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Variance of the motion directions of the 3 x 3 tiles around each tile: 1 minus the mean alignment of the " ..
    "directions",
  fails  = "One displacement represents each tile: motions that cross within a tile are missed.",
  size   = { of = "longest" },
  reads  = {
    longest  = { doc = "longest displacement of each tile, px over the exposure" },
    dominant = { doc = "dominant displacement of each tile, read where the tile itself is static, px over the exposure" },
  },
  writes = { variance = { format = "r32f", doc = "variance of directions, 0 (all parallel) to 1 (all perpendicular)" } },
  if_no = { motion = { variance = 0 } },
}
