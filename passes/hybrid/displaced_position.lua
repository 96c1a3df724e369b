-- SPDX-License-Identifier: MIT
-- Pixels whose position after displacement by their motion shows a farther instance. Tan, Cui and Bhojan 2020, Ray Mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Pixels whose displaced position shows another, farther instance",
  fails  = "With one tap, misses narrow gaps and background that the displacement skips (spokes of a fan). With more taps, " ..
           "finds gaps that are at least as wide as the distance between taps. Misses self-occlusion of one instance, " ..
           "motion of the background, and depth differences below `depth_margin`.",
  size   = { of = "depth" },
  reads  = {
    depth    = { doc = "linear view depth, metres; +inf for the sky" },
    id       = { uint = true, doc = "instance + 1; 0 for the sky" },
    velocity = { doc = "displacement of the surface, px over the exposure" },
  },
  writes = { candidate = { format = "r8_unorm", doc = "candidate mask, 1 on a candidate" } },
  if_no = { motion = { candidate = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "smallest displacement of a moving pixel; slower pixels count as static" },
    depth_margin     = pass.float { 0.01, min = 0, max = 1, doc = "smallest relative depth difference of a farther instance" },
    limit            = blur.limit,
    taps             = pass.int { 1, min = 1, max = 64, doc = "number of tested positions along the displacement" },
  },
  counters = { off_screen = "displaced positions outside the image, counted as candidates" },
}
