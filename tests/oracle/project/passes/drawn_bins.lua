-- SPDX-License-Identifier: MIT
-- Draws a buffer as an image. The pass reads the buffer without running over it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "drawn_bins",
  shader = "drawn_bins",
  doc    = "First 16 numbers of a buffer",
  size   = { 16, 1 },
  reads  = { bins = { buffer = true, doc = "any numbers" } },
  writes = { drawn = { format = "r32f", doc = "the numbers" } },
}
