-- SPDX-License-Identifier: MIT
-- Pixels that move or may be passed over by a moving surface.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Pixels that move, or whose tile a moving surface may reach",
  fails  = "Wastes rays: marks whole tiles around every moving surface, although most pixels of these tiles disocclude " ..
           "nothing. Does not miss surfaces that move by less than the displacement limit. At the border of the image, " ..
           "revealed surfaces are mistaken for surfaces that enter from outside.",
  size   = { of = "velocity" },
  reads  = {
    velocity = { doc = "displacement of the surface, px over the exposure" },
    dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "mask of the ray reveal, 1 where a ray is traced" } },
  if_no = { motion = { mask = 0 } },
  params = {
    tile             = blur.tile,
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "smallest displacement of a moving pixel" },
  },
}
