-- SPDX-License-Identifier: MIT
-- Per cell, intervals that contain the displacements and path deviations of the unreliable texels, whose stored motion may be
-- wrong.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest displacement and path deviation in each cell, component by component, of the unreliable " ..
           "texels: texels whose stored motion may be wrong",
  fails  = "Never too narrow, but may be too wide: the bounds of a cell with two very different motions also contain " ..
           "displacements that no texel has.",
  size   = { of = "velocity", divide = "cell_side" },
  reads  = {
    velocity       = { doc = "screen displacement of the surface, px over the exposure" },
    path_deviation = { doc = "offset of the surface, at mid-exposure, from the straight line between the ends of its screen " ..
                             "path, px" },
    valid          = { doc = "mask, above 1/2 at the unreliable texels; the bounds include only these" },
  },
  writes = {
    bounds = { format = "rgba32f",
      doc = "bounds of the displacements of the unreliable texels in each cell: least x and y, greatest x and y, px over " ..
            "the exposure; 0 if a cell has no unreliable texel" },
    deviation_bounds  = { format = "rgba32f",
      doc = "bounds of the path deviations of the unreliable texels in each cell: least x and y, greatest x and y, px; 0 " ..
            "if a cell has no unreliable texel" },
  },
  if_no = { valid = { bounds = 0, deviation_bounds = 0 }, moving_rect = { bounds = 0, deviation_bounds = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
  },
}
