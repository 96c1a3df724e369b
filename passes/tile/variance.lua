-- SPDX-License-Identifier: MIT
-- How much the directions of motion differ around each tile. Guertin et al. 2014.
local pass = require "strobe.pass"

return pass.compute {
  name   = "tile_variance",
  shader = "tile/variance",
  doc    = "1 minus the mean alignment of the longest displacements of the 3 x 3 tiles around",
  fails  = "It knows one displacement per tile: motions that cross within a tile go unnoticed.",
  size   = { of = "longest" },
  reads  = {
    longest  = { doc = "px over the exposure, longest of each tile" },
    dominant = { doc = "px over the exposure, per tile: stands for a tile that is at rest itself" },
  },
  writes = { variance = { format = "r32f", doc = "0 (all along one line) to 1 (all across it)" } },
  without = { motion = { variance = 0 } },
}
