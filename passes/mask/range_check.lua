-- SPDX-License-Identifier: MIT
-- Moving pixels from which an edge lies within their displacement. Tan, Cui and Bhojan 2020, Ray Mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_range_check",
  shader = "mask/range_check",
  doc    = "Pixels that meet an edge along their displacement",
  fails  = "It marks by the motion of the pixel itself, where its motion relative to what is behind decides: too " ..
           "little over a background that moves against it, nothing for a foreground at rest before a moving " ..
           "background, too much where both move together. Steps longer than an edge is wide miss it.",
  size   = { of = "edge" },
  reads  = {
    edge     = { doc = "above 1/2 on an edge" },
    id       = { uint = true, doc = "instance + 1; sky = 0" },
    velocity = { doc = "px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where something is to be revealed" } },
  without = { edge = { mask = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px", doc = "slower pixels are at rest" },
    limit            = blur.limit,
    taps             = pass.int { 0, min = 0, max = 1024, doc = "steps along the displacement; 0 = one per pixel" },
    own_edge         = pass.bool { true, doc = "the first edge met must belong to the pixel's own instance" },
  },
}
