-- SPDX-License-Identifier: MIT
-- How far the two halves of truth's samples differ, per block of pixels.
local pass = require "strobe.pass"

local half = { doc = "rgb: mean of one half of the samples, linear; a: their number" }

return pass.compute {
  name   = "truth_spread",
  shader = "truth/spread",
  doc    = "Squared difference of two halves of the samples, summed over blocks of pixels",
  size   = { of = "mean_a", divide = "block" },
  reads  = { mean_a = half, mean_b = half },
  writes = { spread = { format = "rg32f",
    doc = "sum of squares over pixels and channels; pixels, 0 = not known yet" } },
  params = { block = pass.int { 32, min = 1, max = 1024, unit = "px", doc = "side of a block" } },
}
