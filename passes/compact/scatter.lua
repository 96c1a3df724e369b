-- SPDX-License-Identifier: MIT
-- List of the masked pixels, so that later passes run on these pixels alone; last of three passes of the stream compaction.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "List of the masked pixels in a fixed order, one square of 8 x 8 pixels after the other; later passes " ..
           "run on the listed pixels alone",
  fails  = "Does not fail: every masked pixel is listed once.",
  size   = { of = "bits" },
  reads  = {
    bits   = { uint = true, doc = "mask of each square of 8 x 8 pixels, one bit per pixel" },
    before = { uint = true, doc = "for each square of 8 x 8 pixels, number of masked pixels in the squares to its left, in " ..
                                  "the same row" },
    totals = { buffer = true, doc = "number of masked pixels in each row of squares" },
  },
  writes = { list = { format = "buffer32ui", each = 64,
    doc = "masked pixels, their number, and the number of work groups to dispatch" } },
}
