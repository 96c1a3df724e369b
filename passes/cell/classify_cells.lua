-- SPDX-License-Identifier: MIT
-- Cells that a moving surface reaches within the exposure; all other cells need no blur.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.compute {
  doc    = "Cells that a moving surface passes over within the exposure, and cells that a revealed surface passes over",
  fails  = "The marks are conservative: extra cells around a cell with several motions may be marked.",
  size   = { of = "bounds" },
  reads  = {
    bounds            = { doc = "bounds of the displacements in each cell, px over the exposure" },
    background_bounds = { doc = "bounds of the displacements of the revealed surfaces in each cell, px over the exposure" },
    dominant          = { doc = "longest displacement that reaches each tile, px over the exposure" },
    second         = { absent = "dominant",
      doc = "displacement around each tile that differs most from the dominant displacement, px over the exposure" },
    second_post   = { absent = "dominant_post",
      doc = "displacement around each tile that differs most from `dominant_post`, px over the exposure" },
    dominant_post = { absent = "dominant",
      doc = "dominant displacement of each tile at times after the raster time, px over the exposure" },
    revealed_dominant = { absent = "dominant",
      doc = "dominant displacement of each tile of the revealed layer, px over the exposure" },
    revealed_dominant_post = { absent = "dominant_post",
      doc = "dominant displacement of each tile of the revealed layer at times after the raster time, px over the exposure" },
    max_displacement               = max_displacement,
    max_displacement_post          = max_displacement,
    revealed_max_displacement      = max_displacement,
    revealed_max_displacement_post = max_displacement,
  },
  writes = {
    moved  = { cleared = true, format = "r8_unorm",
      doc = "1 if a moving surface is in the cell at some time of the exposure, otherwise 0" },
    background = { cleared = true, format = "r8_unorm",
      doc = "1 if a revealed surface is in the cell at some time of the exposure, otherwise 0" },
    unlisted = { cleared = true, format = "r8_unorm",
      doc = "1 if a surface reaches the cell by a displacement that differs from all candidate displacements, otherwise 0" },
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    slowest   = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "largest displacement, before or after the raster time, that counts as static" },
    samples   = blur.samples { doc = "number of time samples of the filter; with fewer samples, more cells are marked" },
  },
}
