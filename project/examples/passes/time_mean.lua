-- SPDX-License-Identifier: MIT
-- Running mean of the images that a loop makes, one per iteration. The pass reads and writes `mean` (an update). `mean` is zero
-- before the loop and keeps its value from iteration to iteration.
local pass = require "strobe.pass"

return pass.compute {
  doc     = "Mean of the images of all iterations so far",
  size    = { of = "color" },
  reads   = { color = { doc = "image of one time, linear radiance" } },
  updates = { mean = { format = "rgba32f", doc = "mean so far, linear radiance; alpha 1" } },
}
