-- SPDX-License-Identifier: MIT
-- Which pixels of each square are masked: the first of three passes that list them.
local pass = require "strobe.pass"

return pass.compute {
  name   = "listed_squares",
  shader = "list/listed_squares",
  doc    = "Which pixels of each square are masked",
  fails  = "Never.",
  size   = { of = "mask", divide = "listed_side" },
  reads  = { mask = { doc = "above 0.5 at the pixels that are listed" } },
  writes = { bits = { format = "rg32ui", doc = "a bit for each pixel of a square, in the order of the list" } },
  params = {
    listed_side = pass.int { 8, min = 8, max = 8, unit = "px", wired = true, doc = "side of a square" },
  },
}
