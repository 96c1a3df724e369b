-- SPDX-License-Identifier: MIT
-- Conservative interval of the displacements of each cell.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest displacement in each cell, component by component",
  fails  = "Never too narrow, but may be too wide: the bounds of a cell with two very different motions also contain " ..
           "displacements that no texel has.",
  size   = { of = "velocity", divide = "cell_side" },
  reads  = {
    velocity      = { doc = "screen displacement of the surface, px over the exposure" },
    velocity_post = { absent = "velocity",
      doc = "screen displacement of the surface in the part of the exposure after the raster time, scaled to the length " ..
            "of the whole exposure, px" },
    curve         = { absent = 0, needs = "curve",
      doc = "curve of the screen path of each surface, as coefficients of a parabola or an arc; 0 for a straight line" },
    valid         = { absent = 1, doc = "mask, above 1/2 at texels that the bounds include" },
  },
  writes = { bounds = { format = "rgba32f",
    doc = "bounds of the displacements: least x and y, greatest x and y, px over the exposure; if no texel of a cell is " ..
          "included, least exceeds greatest" } },
  if_no = { moving_rect = { bounds = 0 } },
  -- Outside of the rectangle that contains all moving objects, the stand-in would be 0. With the mask `valid`, 0 would be wrong
  -- there: a cell without an included texel has empty bounds (least above greatest). So the pass runs everywhere.
  runs   = "everywhere",
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    trajectory = blur.trajectory { wired = true },
  },
}
