-- SPDX-License-Identifier: MIT
-- Union of two sets of time samples of ground truth, for example the first samples and the samples of a later loop.
local pass = require "strobe.pass"

local half = { doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" }
local bits = { uint = true,
  doc = "regions for error reports that contain the pixel, as bits. 1 inner: a farther instance at some time; 2 hidden: a " ..
        "disoccluded surface; 4 outer: a nearer instance; 8 self: a disoccluded part of the instance visible at the raster " ..
        "time" }

return pass.compute {
  doc    = "Union of two sets of time samples: means are weighted by the numbers of samples, and regions are combined by " ..
           "bitwise or",
  size   = { of = "first_a" },
  reads  = { first_a = half, first_b = half, more_a = half, more_b = half, first_regions = bits, more_regions = bits },
  writes = {
    mean_a  = { format = "rgba32f",
      doc = "mean of one half of all samples, linear radiance; alpha: number of samples in that half" },
    mean_b  = { format = "rgba32f",
      doc = "mean of the other half of all samples, linear radiance; alpha: number of samples in that half" },
    regions = { format = "r32ui",
      doc = "regions for error reports that contain the pixel, as bits. 1 inner: a farther instance at some time; 2 hidden: " ..
            "a disoccluded surface; 4 outer: a nearer instance; 8 self: a disoccluded part of the instance visible at the " ..
            "raster time" },
  },
}
