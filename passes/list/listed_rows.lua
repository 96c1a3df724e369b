-- SPDX-License-Identifier: MIT
-- Where each square's pixels begin on the list, row by row: the second of three passes that list masked pixels.
local pass = require "strobe.pass"

return pass.compute {
  name   = "listed_rows",
  shader = "list/listed_rows",
  doc    = "Of each square, how many pixels are listed in its row in front of it, and of each row how many are",
  fails  = "Never: it adds.",
  size   = { of = "bits" },
  reads  = { bits = { uint = true, doc = "a bit for each pixel of a square" } },
  writes = {
    before = { format = "r32ui", doc = "pixels listed in front of the square, of its row" },
    totals = { format = "buffer32ui", doc = "pixels listed of each row of squares" },
  },
}
