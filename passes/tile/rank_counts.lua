-- SPDX-License-Identifier: MIT
-- How many pixels have each rank.
local pass = require "strobe.pass"

return pass.compute {
  name   = "rank_counts",
  shader = "tile/rank_counts",
  doc    = "Per strip of the picture, how many pixels have a rank of each group, or each rank of one group",
  fails  = "Never: it counts. Each pixel is read sixteen times.",
  size   = { 16, 64 },
  reads  = {
    rank  = { uint = true, doc = "of each pixel, 0 to 4095" },
    group = { optional = true, uint = true, doc = "one texel: the group whose ranks are counted; absent: all groups are" },
  },
  writes = { counts = { format = "rgba32ui", doc = "pixels, of four groups or ranks; a row for each strip" } },
}
