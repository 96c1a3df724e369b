-- SPDX-License-Identifier: MIT
-- Stop test for the time samples of ground truth.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Stop the loop over time samples once the standard error of their mean is within the tolerance",
  size   = { 1, 1 },
  reads  = { half_difference = { doc = "per block of pixels, x: sum of the squared differences between the means of two " ..
                                       "halves of the samples; y: number of pixels" } },
  writes = { stop = { format = "r32f", doc = "1 to stop the loop, otherwise 0" } },
  params = {
    tolerance   = pass.float { 0.001, min = 0, max = 1e6, doc = "largest standard error of the mean, linear radiance" },
    min_samples = pass.int { 64, min = 1, max = 65536, doc = "smallest number of samples before the loop may stop" },
  },
}
