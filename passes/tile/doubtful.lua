-- SPDX-License-Identifier: MIT
-- Cells and times at which layers are not to be trusted.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"

local at_end = { optional = true, doc = "the same of what an end of the exposure alone sees; absent: nothing" }
local behind = { optional = true, doc = "the same of what was revealed; absent: nothing was" }

return pass.compute {
  name   = "doubtful",
  shader = "tile/doubtful",
  doc    = "At which times of the exposure something is in a cell of which layers do not say truly where it is",
  fails  = "Of a cell of many motions it takes too many around it. A path that no parabola follows may leave its bounds.",
  size   = { of = "bounds" },
  reads  = {
    bounds        = { doc = "of the displacements of what is doubtful in each cell, px over the exposure" },
    bends         = { doc = "of how far its paths are from straight lines, px in the middle of the exposure" },
    behind_bounds = behind, behind_bends = behind,
    open_bounds   = at_end, open_bends = at_end, close_bounds = at_end, close_bends = at_end,
  },
  updates = { doubtful = { format = "r32ui",
    doc = "a bit for each sample at which something doubtful is there; of more than 32 for as many together" } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    samples   = blur.samples { doc = "time samples" },
    jittered  = pass.int { 0, min = 0, max = 1, wired = true,
      doc = "1 where a sample may be anywhere in its part of the exposure" },
  },
}
