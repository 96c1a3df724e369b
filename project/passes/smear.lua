-- SPDX-License-Identifier: MIT
-- Average of the colours along each pixel's own displacement. Change this pass to make your own filter.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Average of the colours along the pixel's own displacement over the exposure",
  fails  = "Moving surfaces are not blurred over static ones, and disoccluded background is missing.",
  size   = { of = "color" },
  reads  = {
    color    = { doc = "colour, linear radiance" },
    velocity = { doc = "displacement, px over the exposure" },
  },
  writes = { color = { format = "rgba32f", doc = "averaged colour, linear radiance; alpha 1" } },
  params = {
    taps = pass.int { 8, min = 1, max = 64, role = "sample_count", doc = "number of averaged colours" },
  },
}
