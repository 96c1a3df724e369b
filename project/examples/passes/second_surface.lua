-- SPDX-License-Identifier: MIT
-- A ray per pixel: colour of the second surface on the ray, averaged with the colour of the first.
local pass = require "strobe.pass"

return pass.trace {
  doc    = "Average of the colours of the first two instances on the camera's ray",
  fails  = "A second layer of the same instance is skipped.",
  size   = { of = "hit" },
  reads  = {
    hit   = { uint = true, doc = "visible surface: instance + 1 (0 for the sky), geometry, primitive" },
    color = { doc = "colour of the visible surface, linear radiance" },
  },
  writes = { picture = { format = "rgba32f", doc = "averaged colour, linear radiance; alpha 1" } },
  params = { share = pass.float { 0.5, min = 0, max = 1, doc = "share of the second surface's colour" } },
  counters = { found = "pixels with a second surface" },
}
