-- SPDX-License-Identifier: MIT
-- How far off a few samples are, per tile.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_tile_error",
  shader = "truth/tile_error",
  doc    = "Standard error of the mean of a few samples, per tile, from two halves of them",
  size   = { of = "spread" },
  reads  = { spread = { doc = "per tile: sum of squared differences of two halves over pixels and channels, pixels" } },
  writes = { tile_error = { format = "rg32f",
    doc = "linear radiance: of the tile itself; the larger of that and of the mean around it" } },
}
