-- SPDX-License-Identifier: MIT
-- Surfaces and colours of one step of the exposure, which the pass store_pose stored.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Surface and colour of each pixel in one step of the exposure",
  reads  = { poses = { buffer = true, doc = "output of the pass store_pose" } },
  writes = {
    hit   = { format = "rgba32ui", doc = "surface, by indices: instance + 1 (0 for the sky), geometry, triangle, 0" },
    color = { format = "rgba32f", doc = "colour, linear radiance; alpha 1" },
  },
}
