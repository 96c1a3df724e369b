-- SPDX-License-Identifier: MIT
-- Mean of the time samples of ground truth, and the error of that mean.
local pass = require "strobe.pass"

local half = { doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" }

return pass.compute {
  doc    = "Mean of all time samples, from the means of two halves of the samples; the error of the mean is half of the " ..
           "difference of these two means",
  size   = { of = "mean_a" },
  reads  = { mean_a = half, mean_b = half },
  writes = {
    color = { format = "rgba32f", doc = "mean of all samples, linear radiance; alpha 1" },
    error = { format = "rgba32f",
      doc = "half of the absolute difference of both means, linear radiance; alpha: number of samples" },
  },
}
