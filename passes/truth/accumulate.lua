-- SPDX-License-Identifier: MIT
-- One rasterised time sample of ground truth, added to one of two half buffers. A loop repeats the pass over the
-- exposure.
local pass = require "strobe.pass"

local function half(which)
  return { format = "rgba32f",
    doc = "mean of the samples of " .. which .. " iterations, linear radiance; alpha: number of those samples" }
end

return pass.compute {
  doc     = "Running means of the time samples in two half buffers: images of even iterations are added to the first, " ..
            "images of odd iterations to the second",
  size    = { of = "color" },
  reads   = { color = { doc = "image of one time sample, linear radiance" } },
  updates = { mean_a = half "even", mean_b = half "odd" },
}
