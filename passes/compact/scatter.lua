-- SPDX-License-Identifier: MIT
-- List of masked pixels that a pass runs over; last of three passes of the stream compaction.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "List of the masked pixels, square by square, in a fixed order",
  fails  = "Does not fail: every masked pixel is listed once.",
  size   = { of = "bits" },
  reads  = {
    bits   = { uint = true, doc = "mask of each square of 8 x 8 pixels, one bit per pixel" },
    before = { uint = true, doc = "number of masked pixels in earlier squares of the same row" },
    totals = { buffer = true, doc = "number of masked pixels in each row of squares" },
  },
  writes = { list = { format = "buffer32ui", each = 64,
    doc = "masked pixels, their number, and the number of work groups to dispatch" } },
}
