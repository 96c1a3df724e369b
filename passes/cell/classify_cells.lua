-- SPDX-License-Identifier: MIT
-- Cells that a moving surface reaches within the exposure; all other cells need no blur.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.compute {
  doc    = "Two flags per cell. `moved`: a moving surface is in the cell at some time of the exposure. " ..
           "`background`: a surface revealed behind the raster layer is in the cell at some time",
  fails  = "Never misses a cell, because the flags are conservative. Extra cells are marked around a cell that contains " ..
           "several motions.",
  size   = { of = "bounds" },
  reads  = {
    bounds            = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    background_bounds = { doc = "least and greatest displacement of the surfaces revealed behind the raster layer in each " ..
                                "cell, component by component, px over the exposure" },
    max_displacement               = max_displacement,
    max_displacement_post          = max_displacement,
    revealed_max_displacement      = max_displacement,
    revealed_max_displacement_post = max_displacement,
  },
  writes = {
    moved  = { cleared = true, format = "r8_unorm",
      doc = "1 if a moving surface is in the cell at some time of the exposure, otherwise 0" },
    background = { cleared = true, format = "r8_unorm",
      doc = "1 if a surface revealed behind the raster layer is in the cell at some time of the exposure, otherwise 0" },
  },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    samples   = blur.samples { doc = "number of time samples of the filter that reads the flags; with fewer samples the " ..
                                     "filter searches farther around its taps, so that more cells are marked" },
  },
}
