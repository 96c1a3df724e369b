-- SPDX-License-Identifier: MIT
-- Difference of the two half buffers of ground truth, per block of pixels; first step of the stop test.
local pass = require "strobe.pass"

local half = { doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" }

return pass.compute {
  doc    = "Squared difference between the means of two halves of the time samples, summed over blocks of pixels: a measure " ..
           "of the error of the mean of all samples",
  size   = { of = "mean_a", divide = "block" },
  reads  = { mean_a = half, mean_b = half },
  writes = { half_difference = { format = "rg32f",
    doc = "x: sum of the squared differences over the pixels and channels of each block; y: number of pixels in the block. " ..
          "Both are 0 until both halves have samples" } },
  params = { block = pass.int { 32, min = 1, max = 1024, unit = "px", doc = "side of a square block of pixels" } },
}
