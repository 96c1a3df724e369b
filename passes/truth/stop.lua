-- SPDX-License-Identifier: MIT
-- Whether truth has as many time samples as it needs.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_stop",
  shader = "truth/stop",
  doc    = "Stops the samples once the standard error of their mean is small enough",
  size   = { 1, 1 },
  reads  = { spread = { doc = "per block: sum of squared differences of two halves, number of pixels" } },
  writes = { stop = { format = "r32f", doc = "1 = stop" } },
  params = {
    tolerance   = pass.float { 0.001, min = 0, max = 1e6, doc = "standard error of the mean, linear radiance" },
    min_samples = pass.int { 64, min = 1, max = 65536, doc = "samples before the test means anything" },
  },
}
