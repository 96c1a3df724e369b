-- SPDX-License-Identifier: MIT
-- Cells where layers are not to be trusted.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.compute {
  name   = "doubtful",
  shader = "tile/doubtful",
  doc    = "The cells that something passes within the exposure of which layers do not say truly where it is",
  fails  = "Of a cell of many motions it takes too many around it.",
  size   = { of = "bounds" },
  reads  = {
    bounds        = { doc = "of the displacements of what is doubtful in each cell, px over the exposure" },
    behind_bounds = { optional = true, doc = "the same of what was revealed" },
    open_bounds   = { optional = true, doc = "the same of what the start of the exposure sees" },
    close_bounds  = { optional = true, doc = "the same of what its end sees" },
    reach = reach,
  },
  writes = { doubtful = { format = "r8_unorm", doc = "1 where something doubtful comes" } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
  },
}
