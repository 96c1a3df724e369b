-- SPDX-License-Identifier: MIT
-- Threshold of the priority above which at most a share of the pixels lie.
local pass = require "strobe.pass"

return pass.compute {
  shader = "rank_limit",
  doc    = "Threshold of the priority above which at most a share of the pixels lie",
  fails  = "Selects all pixels of one priority or none, so the share is not used up if many pixels have equal priority.",
  size   = { 1, 1 },
  reads  = {
    priority = { uint = true, doc = "priority of each pixel, 0 to 4095" },
    counts   = { buffer = true, doc = "number of pixels with each priority" },
  },
  writes = { limit = { format = "r32ui", doc = "threshold, 0 to 4095; pixels above it are selected" } },
  params = {
    most_pixels = pass.float { 1, min = 0, max = 1, doc = "share of the picture's pixels" },
    most_part   = pass.float { 1, min = 0, max = 1, doc = "part of `most_pixels` that this selection may use" },
  },
}
