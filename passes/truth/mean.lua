-- SPDX-License-Identifier: MIT
-- Mean of the time samples of truth, and the error of that mean.
local pass = require "strobe.pass"

local half = { doc = "rgb: mean of one half of the samples, linear; a: their number" }

return pass.compute {
  name   = "truth_mean",
  shader = "truth/mean",
  doc    = "Mean of two halves of the samples and half their difference",
  size   = { of = "mean_a" },
  reads  = { mean_a = half, mean_b = half },
  writes = {
    color = { format = "rgba32f", doc = "linear; alpha 1" },
    error = { format = "rgba32f", doc = "rgb: half the difference of the halves' means; a: number of samples" },
  },
}
