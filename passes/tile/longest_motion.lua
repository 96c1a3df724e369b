-- SPDX-License-Identifier: MIT
-- How far anything in the picture moves: what limit = auto stands for.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local more = { optional = true, doc = "the same of another layer, or of times after the capture" }

return pass.compute {
  name   = "longest_motion",
  shader = "tile/longest_motion",
  doc    = "The longest displacement of the picture",
  fails  = "Never. One thread reads all tiles: of a large picture with tiles of a pixel or two that takes long.",
  size   = { 1, 1 },
  reads  = {
    longest = { doc = "px over the exposure, longest of each tile" },
    after = more, revealed = more, revealed_after = more,
    curve = { optional = true, needs = "curve", doc = "of the paths of longest, px; absent: lines" },
  },
  writes = { reach = { format = "r32f", doc = "px over the exposure, one texel" } },
  without = { motion = { reach = 0 } },
  params = { trajectory = blur.trajectory { wired = true } },
}
