-- SPDX-License-Identifier: MIT
-- How many pixels have each rank.
local pass = require "strobe.pass"

return pass.compute {
  name   = "rank_counts",
  shader = "rank_counts",
  doc    = "How many pixels have each rank",
  fails  = "Never: it counts.",
  size   = { 64, 64 },
  reads  = { rank = { uint = true, doc = "of each pixel, 0 to 4095; 0 where nothing is asked for" } },
  writes = { counts = { format = "buffer32ui", doc = "pixels of each rank but 0" } },
}
