-- SPDX-License-Identifier: MIT
-- Difference of the two half buffers of ground truth, per block of pixels.
local pass = require "strobe.pass"

local half = { doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" }

return pass.compute {
  doc    = "Squared difference of both half buffers, summed over blocks of pixels",
  size   = { of = "mean_a", divide = "block" },
  reads  = { mean_a = half, mean_b = half },
  writes = { half_difference = { format = "rg32f",
    doc = "x: sum of squared differences over pixels and channels, y: number of pixels; 0 until both halves have samples" } },
  params = { block = pass.int { 32, min = 1, max = 1024, unit = "px", doc = "side of a square block of pixels" } },
}
