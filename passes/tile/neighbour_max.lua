-- SPDX-License-Identifier: MIT
-- The longest displacement that can reach each tile. McGuire et al. 2012, section 2.2; off-axis rule: Guertin et al.
-- 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.compute {
  name   = "neighbour_max",
  shader = "tile/neighbour_max",
  doc    = "Longest displacement among the tiles around that can reach each tile within the exposure",
  fails  = "A tile is judged by its longest displacement: a slower pixel of it that comes this way, while the longest "
    .. "does not, is lost. Where the dominant displacement changes, borders of tiles show.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "px over the exposure, longest of each tile" },
    motions = { optional = true, doc = "two displacements that stand for all in a tile, px over the exposure" },
    curve = { optional = true, needs = "curve", doc = "of the path of that, px; absent: lines" },
    place = { optional = true, needs = "curve", doc = "px, the texel that has it" },
    reach = reach,
  },
  writes = {
    dominant = { format = "rg32f", doc = "px over the exposure" },
    dominant_curve = { format = "rgba32f", doc = "of its path, px" },
    dominant_place = { format = "rg32f", doc = "px, the texel that has it; 0 where paths are lines" },
    second   = { format = "rg32f", doc = "what differs most from it, px over the exposure; dominant if nothing does" },
  },
  without = { motion = { dominant = 0, dominant_curve = 0, dominant_place = 0, second = 0 } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
    trajectory = blur.trajectory { wired = true },
    rule  = pass.choice { "reach", "sign", "all", default = "reach", doc = "which of the tiles around count",
      values = {
        reach = "Those whose box moves over this one within the exposure. Fails for a slow pixel of a tile whose "
          .. "longest displacement passes by.",
        sign = "Those that point here, on every axis on which they lie off (Guertin et al. 2014). Fails as reach "
          .. "does, and lets distant tiles dominate that stop short of this one.",
        all = "Every tile in range (McGuire et al. 2012). Fails by letting motion dominate that never comes here.",
      } },
  },
}
