-- SPDX-License-Identifier: MIT
-- Longest displacement of each tile, of one layer or of both layers. McGuire et al. 2012, section 2.2.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local nothing = { longest = 0, curve_of_it = 0, place_of_it = 0, max_displacement = 0 }

return pass.compute {
  doc    = "Longest displacement in each tile, of one layer or of two layers; displacements longer than `limit` are shortened",
  fails  = "Each tile is represented by one displacement: all shorter displacements, and others of equal length, are lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity       = { doc = "screen displacement of the surface, px over the exposure" },
    valid          = { absent = 1, doc = "mask, above 1/2 at texels that the maximum includes" },
    curve          = { absent = 0, needs = "curve",
      doc = "curve of the screen path of each surface, as coefficients of a parabola or an arc; 0 for a straight line" },
    extra_curve    = { absent = 0, needs = "curve",
      doc = "curve of each screen path of the second layer, as coefficients of a parabola or an arc; 0 for a straight line" },
    extra_velocity = { optional = true,
      doc = "screen displacement of a second layer at the same pixels, px over the exposure; absent: one layer" },
    extra_valid    = { absent = 1, doc = "mask, above 1/2 at texels of the second layer that the maximum includes" },
  },
  writes = { longest = { format = "rg32f",
               doc = "longest displacement in each tile, px over the exposure; of equally long displacements, the first in " ..
                     "raster order" },
             curve_of_it = { format = "rgba32f",
               doc = "curve of the path with the longest displacement, as coefficients of a parabola or an arc; 0 for a " ..
                     "straight line" },
             place_of_it = { format = "rg32f",
               doc = "position of the texel that has the longest displacement in each tile, px; 0 if paths are straight " ..
                     "lines" },
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
    doc   = "pixels (of either layer) that move farther than the limit of displacements",
    limit = "each such displacement was shortened, so that the blur is too short; ground truth has no limit. Raise " ..
            "`limit`, or shorten the exposure",
  } },
}
