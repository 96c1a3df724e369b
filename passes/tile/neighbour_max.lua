-- SPDX-License-Identifier: MIT
-- Longest displacement that can reach each tile. McGuire et al. 2012, section 2.2; off-axis rule: Guertin et al. 2014.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.compute {
  doc    = "Dominant displacement of each tile: the longest displacement of the surrounding tiles that can bring a surface " ..
           "to this tile within the exposure",
  fails  = "Each tile is tested by its longest displacement alone: a slower surface that reaches another tile is lost if " ..
           "the longest displacement does not lead to that tile. Tile borders become visible where the dominant " ..
           "displacement changes.",
  size   = { of = "longest" },
  reads  = {
    longest = { doc = "longest displacement in each tile, px over the exposure" },
    velocities = { absent = 0, doc = "two further displacements of each tile, which may become the output `second`, " ..
                                     "px over the exposure" },
    curve = { absent = 0, needs = "curve",
      doc = "curve of the path with each tile's longest displacement, as coefficients of a parabola or an arc; 0 for a " ..
            "straight line" },
    place = { absent = 0, needs = "curve",
      doc = "position of the texel that has the longest displacement in each tile, px" },
    max_displacement = max_displacement,
  },
  writes = {
    dominant = { format = "rg32f", doc = "longest displacement that can bring a surface to each tile, px over the exposure" },
    dominant_curve = { format = "rgba32f",
      doc = "curve of the path with the dominant displacement, as coefficients of a parabola or an arc; 0 for a straight " ..
            "line" },
    dominant_place = { format = "rg32f",
      doc = "position of the texel that has the dominant displacement, px; 0 if paths are straight lines" },
    second   = { format = "rg32f",
      doc = "displacement that can bring a surface to each tile and differs most from `dominant`, px over the exposure; " ..
            "equal to `dominant` if no displacement differs" },
  },
  if_no = { motion = { dominant = 0, dominant_curve = 0, dominant_place = 0, second = 0 } },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
    trajectory = blur.trajectory { wired = true },
    rule  = pass.choice { "swept_box", "sign", "all", default = "swept_box",
      doc = "test that decides which of the surrounding tiles may bring a surface to a tile",
      values = {
        swept_box = "Accepts a tile if its box, moved by its longest displacement, passes over this tile within the exposure. "
          .. "Fails for a slower pixel that reaches this tile although that box does not.",
        sign = "Accepts tiles whose displacement points to this tile on every axis that separates the two tiles (Guertin et "
          .. "al. 2014). Fails as `swept_box` does, and lets distant tiles dominate although their motion ends before this "
          .. "tile.",
        all = "Accepts every tile within the search radius (McGuire et al. 2012). Fails by accepting motion that never "
          .. "reaches this tile.",
      } },
  },
}
