-- SPDX-License-Identifier: MIT
-- Sum of two sets of samples.
local pass = require "strobe.pass"

local half = { doc = "rgb: mean of one half of the samples, linear; a: their number" }
local bits = { uint = true, doc = "bits: 1 inner, 2 hidden, 4 outer, 8 self" }

return pass.compute {
  name   = "truth_joined_halves",
  shader = "truth/joined_halves",
  doc    = "Joins two sets of samples: means by their numbers, regions or-ed",
  size   = { of = "first_a" },
  reads  = { first_a = half, first_b = half, more_a = half, more_b = half, first_regions = bits, more_regions = bits },
  writes = {
    mean_a  = { format = "rgba32f", doc = "mean radiance of one half of all samples; a = their number" },
    mean_b  = { format = "rgba32f", doc = "mean radiance of the other half; a = their number" },
    regions = { format = "r32ui", doc = "bits: 1 inner, 2 hidden, 4 outer, 8 self" },
  },
}
