-- SPDX-License-Identifier: MIT
-- Threshold on the ray priority of pixels, chosen so that at most a given share of the pixels (the ray budget) exceed it.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Threshold on the ray priority: the smallest value such that at most a given share of the pixels have a higher " ..
           "priority",
  fails  = "Selects all pixels of one priority or none, so a part of the share stays unused if many pixels have the same " ..
           "priority.",
  size   = { 1, 1 },
  reads  = {
    priority = { uint = true, doc = "ray priority of each pixel; only the size of the image is read" },
    counts   = { buffer = true, doc = "entry i: number of pixels with priority i" },
  },
  writes = { limit = { format = "r32ui", doc = "threshold, 0 to 4095; pixels above it are selected" } },
  params = {
    most_pixels = pass.float { 1, min = 0, max = 1, doc = "ray budget: share of the picture's pixels that may have rays" },
    most_part   = pass.float { 1, min = 0, max = 1, doc = "part of the ray budget that this selection may use, 0 to 1" },
  },
}
