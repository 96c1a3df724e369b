-- SPDX-License-Identifier: MIT
-- Intervals, per cell, of the displacements and path deviations of unreliable texels.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "bent_bounds",
  shader = "tile/bent_bounds",
  doc    = "Least and greatest displacement and path deviation of the texels of each cell that count, component by component",
  fails  = "Never. Two motions far apart leave much between their bounds that nothing in the cell has.",
  size   = { of = "velocity", divide = "cell_side" },
  reads  = {
    velocity = { doc = "px over the exposure" },
    bend     = { doc = "how far paths are from straight lines, px in the middle of the exposure" },
    valid    = { doc = "above 1/2 where they count" },
  },
  writes = {
    bounds = { format = "rgba32f", doc = "least x and y, greatest x and y, px over the exposure; 0 where no texel counts" },
    bends  = { format = "rgba32f", doc = "least x and y, greatest x and y of path deviations, px; 0 where no texel counts" },
  },
  without = { valid = { bounds = 0, bends = 0 }, reached = { bounds = 0, bends = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
  },
}
