-- SPDX-License-Identifier: MIT
-- Pixels that move or may be passed over by a moving surface.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mask of the pixels that move, and of all pixels of tiles that a moving surface may reach",
  fails  = "Wastes rays: marks whole tiles around every moving surface, although most pixels of these tiles disocclude " ..
           "nothing. Does not miss surfaces that move by less than the displacement limit. At the border of the image, an " ..
           "object that enters from outside is in no layer: the surface revealed behind the object then wrongly takes its " ..
           "place.",
  size   = { of = "velocity" },
  reads  = {
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
    dominant = { doc = "longest displacement that can bring a surface to each tile, px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "mask for the pass `ray_reveal`: 1 where a ray to the background is " ..
      "traced, otherwise 0" } },
  if_no = { motion = { mask = 0 } },
  params = {
    tile             = blur.tile,
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "smallest displacement of a moving pixel, " ..
        "or of a surface that may reach its tile" },
  },
}
