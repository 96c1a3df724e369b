-- SPDX-License-Identifier: MIT
-- A ray for each pixel of a list.
local pass = require "strobe.pass"

return pass.trace {
  name   = "traced",
  shader = "traced",
  doc    = "Distance to the nearest surface",
  reads  = { listed = { buffer = true, optional = true, doc = "the pixels that it runs for" } },
  dispatch_over = "listed",
  writes = { distance = { format = "r32f", cleared = true, doc = "along the ray, -1 where it meets nothing; 0 elsewhere" } },
}
