-- SPDX-License-Identifier: MIT
-- The list of masked pixels that a pass runs over: the last of three passes that make it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "listed_pixels",
  shader = "list/listed_pixels",
  doc    = "The masked pixels, square by square, always in the same order",
  fails  = "Never.",
  size   = { of = "bits" },
  reads  = {
    bits   = { uint = true, doc = "a bit for each pixel of a square" },
    before = { uint = true, doc = "pixels listed in front of the square, of its row" },
    totals = { buffer = true, doc = "pixels listed of each row of squares" },
  },
  writes = { list = { format = "buffer32ui", each = 64, doc = "pixels, and the groups of invocations for them" } },
}
