-- SPDX-License-Identifier: MIT
-- Prefix sums of the numbers of masked pixels, row by row; second of three passes of the stream compaction.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Prefix sums of the numbers of masked pixels per square, along each row of squares, and the sum of each row",
  fails  = "Does not fail: sums of integers are exact.",
  size   = { of = "bits" },
  reads  = { bits = { uint = true, doc = "mask of each square of 8 x 8 pixels, one bit per pixel" } },
  writes = {
    before = { format = "r32ui", doc = "for each square of 8 x 8 pixels, number of masked pixels in the squares to its " ..
                                       "left, in the same row" },
    totals = { format = "buffer32ui", doc = "number of masked pixels in each row of squares" },
  },
}
