-- SPDX-License-Identifier: MIT
-- Traces a ray for each pixel of a list.
local pass = require "strobe.pass"

return pass.trace {
  name   = "traced",
  shader = "traced",
  doc    = "Distance to the nearest surface",
  reads  = { listed = { buffer = true, optional = true, doc = "pixels of the dispatch" } },
  dispatch_over = "listed",
  writes = { distance = { format = "r32f", cleared = true, doc = "along the ray, -1 without a hit; 0 outside the list" } },
}
