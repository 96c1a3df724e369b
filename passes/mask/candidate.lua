-- SPDX-License-Identifier: MIT
-- Pixels that, displaced by their motion, lie on another and farther instance. Tan, Cui and Bhojan 2020, Ray Mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_candidate",
  shader = "mask/candidate",
  doc    = "Pixels whose displaced position is another instance, farther away",
  fails  = "With one tap a thin gap or background that the displacement jumps over is missed (spokes of a fan); " ..
           "more taps find what is as wide as their distance. Blind to self-occlusion of one instance, to motion of " ..
           "the background, and to gaps of depth smaller than depth_margin.",
  size   = { of = "depth" },
  reads  = {
    depth    = { doc = "linear view depth, metres, sky = +inf" },
    id       = { uint = true, doc = "instance + 1; sky = 0" },
    velocity = { doc = "px over the exposure" },
  },
  writes = { candidate = { format = "r8_unorm", doc = "1 on a candidate" } },
  without = { motion = { candidate = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "slower pixels are at rest" },
    depth_margin     = pass.float { 0.01, min = 0, max = 1, doc = "share of the depth by which farther is farther" },
    limit            = blur.limit,
    taps             = pass.int { 1, min = 1, max = 64, doc = "positions along the displacement that are tested" },
  },
  counters = { off_screen = "displaced positions outside of the picture, taken as candidates" },
}
