-- SPDX-License-Identifier: MIT
-- How many samples a tile gets for its error.
local pass = require "strobe.pass"
local adaptive = require "passes.lib.adaptive"

return pass.compute {
  name   = "truth_sample_rate",
  shader = "truth/sample_rate",
  doc    = "Samples for the error of a tile, such that the picture should be as exact as with `samples` everywhere",
  size   = { 1, 1 },
  reads  = { tile_error = { doc = "linear radiance: of each tile; the larger of that and of the mean around it" } },
  writes = { rate = { format = "rg32f", doc = "samples for an error of 1; the most that any tile gets" } },
  params = {
    samples = adaptive.samples,
    order   = adaptive.order,
    most    = pass.float { 4, min = 1, max = 64, doc = "most samples of a tile, in `samples`" },
  },
}
