-- SPDX-License-Identifier: MIT
-- Where anything comes within the exposure: cells that nothing reaches need no blur.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.compute {
  name   = "motion_reach",
  shader = "tile/motion_reach",
  doc    = "The cells that something in motion passes over within the exposure, and those where something behind shows",
  fails  = "Never by leaving a cell out. Of a cell of many motions it takes too many around it.",
  size   = { of = "bounds" },
  reads  = {
    bounds        = { doc = "of the displacements of each cell, px over the exposure" },
    behind_bounds = { doc = "the same of what was revealed" },
    dominant      = { doc = "px over the exposure, per tile: longest displacement that comes there" },
    second         = { optional = true, doc = "what else comes there" },
    after_second   = { optional = true, doc = "the same at times after the capture" },
    after_dominant = { optional = true, doc = "the same at times after the capture" },
    revealed_dominant = { optional = true, doc = "the same of what was revealed, where dominant is of what raster saw" },
    revealed_after_dominant = { optional = true, doc = "the same of that at times after the capture" },
    reach = reach,
  },
  writes = {
    moved  = { cleared = true, format = "r8_unorm", doc = "1 where something that moves is at some time, 0 where all rests" },
    behind = { cleared = true, format = "r8_unorm", doc = "1 where something revealed is at some time" },
    missed = { cleared = true, format = "r8_unorm", doc = "1 where something comes that moves like none of these" },
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    slowest   = pass.float { 0.5, min = 0, max = 100, unit = "px", doc = "up to here what moves counts as at rest" },
    samples   = blur.samples { doc = "time samples, whose distance decides how exactly places are met" },
  },
}
