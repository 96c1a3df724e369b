-- SPDX-License-Identifier: MIT
-- Cells that a moving surface reaches within the exposure; all other cells need no blur.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.compute {
  doc    = "Flags of each cell: a moving surface is there at some time of the exposure; a surface revealed behind the " ..
           "raster layer is there; a surface arrives by a displacement that is not among the candidates of the filters",
  fails  = "Never misses a cell, because the flags are conservative. Extra cells are marked around a cell that contains " ..
           "several motions.",
  size   = { of = "bounds" },
  reads  = {
    bounds            = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    background_bounds = { doc = "least and greatest displacement of the surfaces revealed behind the raster layer in each " ..
                                "cell, component by component, px over the exposure" },
    dominant          = { doc = "candidate displacement of each tile, the longest that can bring a surface to the tile, px " ..
                                "over the exposure" },
    second         = { absent = "dominant",
      doc = "candidate displacement of each tile, the most different from `dominant`, px over the exposure" },
    second_post   = { absent = "dominant_post",
      doc = "candidate displacement of each tile, the most different from `dominant_post`, px over the exposure" },
    dominant_post = { absent = "dominant",
      doc = "dominant displacement of each tile after the raster time, scaled to the whole exposure, px" },
    revealed_dominant = { absent = "dominant",
      doc = "dominant displacement of the surfaces revealed behind the raster layer in each tile, px over the exposure" },
    revealed_dominant_post = { absent = "dominant_post",
      doc = "dominant displacement, after the raster time, of the surfaces revealed behind the raster layer in each tile; " ..
            "scaled to the whole exposure, px" },
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
    unlisted = { cleared = true, format = "r8_unorm",
      doc = "1 if a surface from another cell may reach the cell by a displacement that differs from all candidate " ..
            "displacements of its tile, otherwise 0" },
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    slowest   = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "largest distance that a static surface may move away from its position at the raster time, within the exposure" },
    samples   = blur.samples { doc = "number of time samples of the filter that reads the flags; with fewer samples the " ..
                                     "filter searches farther around its taps, so that more cells are marked" },
  },
}
