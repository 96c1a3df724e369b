-- SPDX-License-Identifier: MIT
-- Down to which rank no more than a share of the pixels are ahead.
local pass = require "strobe.pass"

return pass.compute {
  name   = "rank_limit",
  shader = "rank_limit",
  doc    = "The first rank with which more pixels than a share of them would be ahead",
  fails  = "Pixels of one rank are ahead together or not at all: where many are alike the share is not used up.",
  size   = { 1, 1 },
  reads  = {
    rank   = { uint = true, doc = "of each pixel, 0 to 4095" },
    counts = { buffer = true, doc = "pixels of each rank" },
  },
  writes = { limit = { format = "r32ui", doc = "that rank" } },
  params = {
    most_pixels = pass.float { 1, min = 0, max = 1, doc = "share of the picture's pixels" },
    most_part   = pass.float { 1, min = 0, max = 1, doc = "part of that share which these may have" },
  },
}
