-- SPDX-License-Identifier: MIT
-- Longest displacement of the image: the search radius of filters with limit = auto.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local more = { optional = true,
  doc = "longest displacement of each tile, of another layer or after the raster time, px over the exposure; absent: none" }

return pass.compute {
  name   = "longest_motion",
  shader = "tile/longest_motion",
  doc    = "Longest displacement of the image",
  fails  = "Never. One thread reads all tiles, which is slow for a large image with tiles of one or two pixels.",
  size   = { 1, 1 },
  reads  = {
    longest = { doc = "longest displacement of each tile, px over the exposure" },
    after = more, revealed = more, revealed_after = more,
    curve = { optional = true, needs = "curve",
      doc = "curve of the path of each tile's longest displacement, px; absent: paths are straight lines" },
  },
  writes = { reach = { format = "r32f", doc = "length of the longest displacement, one texel, px over the exposure" } },
  without = { motion = { reach = 0 } },
  params = { trajectory = blur.trajectory { wired = true } },
}
