-- SPDX-License-Identifier: MIT
-- Surfaces and colours of all steps of the exposure, for a later loop over the steps.
local pass = require "strobe.pass"

return pass.compute {
  doc   = "Surface and colour of each pixel in each step of the exposure",
  size  = { of = "color" },
  reads = {
    hit   = { uint = true, doc = "surface of one step, by indices: instance + 1 (0 for the sky), geometry, triangle" },
    color = { doc = "colour of the surface, linear radiance" },
  },
  updates = { poses = { format = "buffer32ui", each = 48,
    doc = "per pixel and step (at most 8), three indices of the surface and three floats of linear radiance" } },
}
