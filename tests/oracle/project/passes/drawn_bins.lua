-- SPDX-License-Identifier: MIT
-- A buffer as an image, by a pass that reads it without running over it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "drawn_bins",
  shader = "drawn_bins",
  doc    = "The first 16 numbers of a buffer",
  size   = { 16, 1 },
  reads  = { bins = { buffer = true, doc = "any numbers" } },
  writes = { drawn = { format = "r32f", doc = "the numbers" } },
}
