-- SPDX-License-Identifier: MIT
-- Pixels that move, or near which something moves.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_moving",
  shader = "mask/moving",
  doc    = "Every pixel that is not still, or that something else may move over",
  fails  = "It marks whole tiles around everything that moves, most of which uncover nothing: rays are wasted, but " ..
           "nothing is missed that moves by less than the limit. At the picture's border what it reveals is taken " ..
           "for what comes in from outside.",
  size   = { of = "velocity" },
  reads  = {
    velocity = { doc = "px over the exposure" },
    dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where something is to be revealed" } },
  without = { motion = { mask = 0 } },
  params = {
    tile             = blur.tile,
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "slower pixels are at rest" },
  },
}
