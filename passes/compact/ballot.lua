-- SPDX-License-Identifier: MIT
-- Mask of each square of pixels, packed into bits; first of three passes of the stream compaction, which lists the masked
-- pixels.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Mask of each square of 8 x 8 pixels, packed into 64 bits",
  fails  = "Does not fail: the bits equal the mask.",
  size   = { of = "mask", divide = "square_side" },
  reads  = { mask = { doc = "mask, above 1/2 at pixels that the list is to contain" } },
  writes = { bits = { format = "rg32ui",
    doc = "mask of each square of 8 x 8 pixels, one bit per pixel, in the order of the pixel list" } },
  params = {
    square_side = pass.int { 8, min = 8, max = 8, unit = "px", wired = true, doc = "side of a square of pixels" },
  },
}
