-- SPDX-License-Identifier: MIT
-- Longest displacement of each tile, of one layer or of both layers. McGuire et al. 2012, section 2.2.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local nothing = { longest = 0, curve_of_it = 0, place_of_it = 0, max_displacement = 0 }

return pass.compute {
  doc    = "Longest displacement of each tile, shortened to the limit",
  fails  = "One displacement represents a tile: slower ones, and others of equal length, are lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity       = { doc = "displacement of the surface, px over the exposure" },
    valid          = { absent = 1, doc = "mask, above 1/2 at texels that count" },
    curve          = { absent = 0, needs = "curve", doc = "curve of the screen path, px; 0 for a straight line" },
    extra_curve    = { absent = 0, needs = "curve",
      doc = "curve of the screen path of the second layer, px; 0 for a straight line" },
    extra_velocity = { optional = true,
      doc = "displacement of a second layer at the same pixels, px over the exposure; absent: one layer" },
    extra_valid    = { absent = 1, doc = "mask, above 1/2 at texels of the second layer that count" },
  },
  writes = { longest = { format = "rg32f",
               doc = "longest displacement, px over the exposure; the first in raster order among equal lengths" },
             curve_of_it = { format = "rgba32f", doc = "curve of the path of the longest displacement, px" },
             place_of_it = { format = "rg32f",
               doc = "texel that has the longest displacement, px; 0 if paths are straight lines" },
             max_displacement = { format = "buffer32ui",
               doc = "entry 0: length of the longest displacement of the image, px over the exposure, as the bits of a " ..
                     "float" } },
  if_no = { motion = nothing, moving_rect = nothing },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
    trajectory = blur.trajectory { wired = true },
  },
  counters = { clamped = {
    doc   = "pixels (of either layer) that move farther than the limit",
    limit = "each displacement was shortened to the limit, so that the blur is too short; ground truth has no limit. Raise " ..
            "`limit`, or shorten the exposure",
  } },
}
