-- SPDX-License-Identifier: MIT
-- Cells that a moving surface reaches within the exposure; all other cells need no blur.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.compute {
  name   = "motion_reach",
  shader = "tile/motion_reach",
  doc    = "Cells that a moving surface passes over within the exposure, and cells that a revealed surface passes over",
  fails  = "Conservative; may mark extra cells around a cell with several motions.",
  size   = { of = "bounds" },
  reads  = {
    bounds        = { doc = "bounds of the displacements in each cell, px over the exposure" },
    behind_bounds = { doc = "bounds of the displacements of the revealed surfaces in each cell, px over the exposure" },
    dominant      = { doc = "longest displacement that reaches each tile, px over the exposure" },
    second         = { optional = true,
      doc = "displacement around each tile that differs most from the dominant one, px over the exposure" },
    after_second   = { optional = true,
      doc = "displacement around each tile that differs most from `after_dominant`, px over the exposure" },
    after_dominant = { optional = true,
      doc = "dominant displacement of each tile at times after the raster time, px over the exposure" },
    revealed_dominant = { optional = true,
      doc = "dominant displacement of each tile of the revealed layer, px over the exposure; absent: `dominant` covers " ..
            "both layers" },
    revealed_after_dominant = { optional = true,
      doc = "dominant displacement of each tile of the revealed layer at times after the raster time, px over the exposure" },
    reach = reach,
  },
  writes = {
    moved  = { cleared = true, format = "r8_unorm",
      doc = "1 if a moving surface is in the cell at some time, 0 if all is static" },
    behind = { cleared = true, format = "r8_unorm", doc = "1 if a revealed surface is in the cell at some time" },
    missed = { cleared = true, format = "r8_unorm",
      doc = "1 if a surface with a motion outside the candidates reaches the cell" },
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    slowest   = pass.float { 0.5, min = 0, max = 100, unit = "px",
      doc = "largest displacement, before or after the raster time, that counts as static" },
    samples   = blur.samples { doc = "number of time samples; fewer samples widen the marked cells" },
  },
}
