-- SPDX-License-Identifier: MIT
-- Pixels that move or may be passed over by a moving surface.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mask of the pixels that move, and of all pixels of tiles that a moving surface may reach",
  fails  = "Wastes rays: marks whole tiles around every moving surface, although most pixels of these tiles disocclude " ..
           "nothing. Does not miss surfaces that move by less than the displacement limit. An object that " ..
           "enters the image from outside is neither in the raster layer nor in the revealed layer. Near the border, the " ..
           "revealed surface is therefore shown in place of this object.",
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
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "smallest displacement that counts as " ..
        "motion, both for the pixel itself and for a surface that may reach the tile of the pixel" },
  },
}
