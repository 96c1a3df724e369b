-- SPDX-License-Identifier: MIT
-- Union of two sets of samples.
local pass = require "strobe.pass"

local half = { doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" }
local bits = { uint = true,
  doc = "regions of the error report that contain the pixel, as bits: 1 inner, 2 hidden, 4 outer, 8 self" }

return pass.compute {
  doc    = "Union of two sets of samples: means weighted by sample count, regions combined by bitwise or",
  size   = { of = "first_a" },
  reads  = { first_a = half, first_b = half, more_a = half, more_b = half, first_regions = bits, more_regions = bits },
  writes = {
    mean_a  = { format = "rgba32f",
      doc = "mean of one half of all samples, linear radiance; alpha: number of samples in that half" },
    mean_b  = { format = "rgba32f",
      doc = "mean of the other half of all samples, linear radiance; alpha: number of samples in that half" },
    regions = { format = "r32ui",
      doc = "regions of the error report that contain the pixel, as bits: 1 inner, 2 hidden, 4 outer, 8 self" },
  },
}
