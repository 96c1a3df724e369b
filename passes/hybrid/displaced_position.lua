-- SPDX-License-Identifier: MIT
-- Displaced-position test of the ray mask: moving pixels that land on a farther instance if they are displaced by their own
-- motion. Tan, Cui and Bhojan 2020, section "Ray Mask".
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Candidates for a ray: moving pixels that land on another, farther instance if they are displaced by their own " ..
           "motion",
  fails  = "With one tap, misses background in gaps that the displacement skips, for example between the spokes of a fan. " ..
           "With more taps, misses gaps that are narrower than the distance between taps. Also misses self-occlusion of one " ..
           "instance, disocclusion by motion of the background alone, and instances that are farther by less than " ..
           "`depth_margin`.",
  size   = { of = "depth" },
  reads  = {
    depth    = { doc = "linear view depth, metres; +inf for the sky" },
    id       = { uint = true, doc = "instance index + 1; 0 for the sky" },
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
  },
  writes = { candidate = { format = "r8_unorm",
    doc = "1 if the displaced position shows another, farther instance or is outside the image, otherwise 0" } },
  if_no = { motion = { candidate = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "smallest displacement of a moving pixel; slower pixels count as static" },
    depth_margin     = pass.float { 0.01, min = 0, max = 1, doc = "smallest depth difference that makes an instance " ..
        "count as farther than the pixel, as a fraction of the pixel's depth" },
    limit            = blur.limit,
    taps             = pass.int { 1, min = 1, max = 64, doc = "number of tested positions along the displacement" },
  },
  counters = { off_screen = "displaced positions outside the image, counted as candidates" },
}
