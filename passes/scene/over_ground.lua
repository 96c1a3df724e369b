-- SPDX-License-Identifier: MIT
-- The mean of time samples of what moves, and of what is at rest at all others.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "over_ground",
  shader = "scene/over_ground",
  doc    = "The mean of samples at which something that moves is seen, and of what is at rest at the others",
  size   = { of = "moving" },
  reads  = {
    moving = { doc = "mean of what moves and is seen, linear; alpha: number of times" },
    ground = { doc = "linear, of what is at rest behind what moves; alpha 0: it is what the capture sees" },
    color  = { doc = "linear, of what the capture sees" },
  },
  writes = { picture = { format = "rgba32f", doc = "linear; alpha 1" } },
  without = { motion = { picture = "color" }, reached = { picture = "color" } },
  counters = { samples = "samples of pixels at which something that moves is seen" },
  params = { samples = blur.samples { doc = "number of all samples" } },
}
