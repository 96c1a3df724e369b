-- SPDX-License-Identifier: MIT
-- The longest displacement of each tile, of one layer or of the union of two. McGuire et al. 2012, section 2.2.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local nothing = { longest = 0, curve_of_it = 0, place_of_it = 0 }

return pass.compute {
  name   = "tile_max",
  shader = "tile/tile_max",
  doc    = "Longest displacement of each tile, shortened to what the filters handle",
  fails  = "One displacement stands for a tile: slower ones, and others of equal length, are lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity       = { doc = "px over the exposure" },
    valid          = { optional = true, doc = "above 1/2 where velocity counts; absent: everywhere" },
    curve          = { optional = true, needs = "curve", doc = "of its path, px; absent: lines" },
    extra_curve    = { optional = true, needs = "curve", doc = "the same of the second layer" },
    extra_velocity = { optional = true, doc = "px over the exposure, of a second layer over the same pixels" },
    extra_valid    = { optional = true, doc = "above 1/2 where extra_velocity counts; absent: everywhere" },
  },
  writes = { longest = { format = "rg32f", doc = "px over the exposure; of equal lengths the first in raster order" },
             curve_of_it = { format = "rgba32f", doc = "of its path, px" },
             place_of_it = { format = "rg32f", doc = "px, the texel that has it; 0 where paths are lines" } },
  without = { motion = nothing, reached = nothing },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
    trajectory = blur.trajectory { wired = true },
  },
  counters = { clamped = {
    doc   = "pixels (of either layer) that move farther than the limit",
    limit = "the filter shortened their displacement to the limit: their blur is shorter than it should be, which truth " ..
            "does not share. Raise `limit`, or shorten the exposure",
  } },
}
