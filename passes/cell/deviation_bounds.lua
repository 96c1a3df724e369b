-- SPDX-License-Identifier: MIT
-- Intervals, per cell, of the displacements and path deviations of unreliable texels.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest displacement and path deviation of the unreliable texels of each cell, component by component",
  fails  = "Does not fail, but can be loose: the bounds of a cell with two very different motions also contain " ..
           "displacements that no texel has.",
  size   = { of = "velocity", divide = "cell_side" },
  reads  = {
    velocity       = { doc = "displacement of the surface, px over the exposure" },
    path_deviation = { doc = "at mid-exposure, offset of the surface from the straight line between the ends of its path, px" },
    valid          = { doc = "mask, above 1/2 at unreliable texels" },
  },
  writes = {
    bounds = { format = "rgba32f",
      doc = "bounds of the displacements: least x and y, greatest x and y, px over the exposure; 0 if no " ..
            "texel is unreliable" },
    deviation_bounds  = { format = "rgba32f",
      doc = "bounds of the path deviations: least x and y, greatest x and y, px; 0 if no texel is unreliable" },
  },
  if_no = { valid = { bounds = 0, deviation_bounds = 0 }, moving_rect = { bounds = 0, deviation_bounds = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
  },
}
