-- SPDX-License-Identifier: MIT
-- Parameters that the passes of a blur share, so that a name means the same in each and follows the pipeline's.
local param = require "strobe.param"

return {
  samples = param.int { 16, min = 1, max = 1024, role = "sample_count", doc = "samples along the motion" },

  tile = param.int { 40, min = 1, max = 1024, unit = "px", role = "tile", doc = "side of a tile" },

  cell_side = param.int { 10, min = 1, max = 1024, unit = "px",
    doc = "side of a cell, in which bounds of displacements tell what need not be looked at" },

  limit = param.float { "auto", min = 0, max = 10, auto = true, unit = "image widths", role = "reach",
    doc = "longest displacement handled; longer ones are shortened and counted. auto: what the picture has, none is" },

  depth_extent = param.float { 0.01, min = 1e-6, max = 1, role = "depth_tolerance",
    doc = "share of the depth over which two depths count as one" },

  trajectory = param.choice { "line", "quadratic", "arc", default = "line",
    doc = "how a point goes over the picture within the exposure; with displacement = extrapolated, as places in earlier " ..
      "frames tell",
    values = {
      line = "In a straight line at an even pace. Fails where things turn: wheels blur in straight lines.",
      quadratic = "On a parabola, through its places at the ends and in the middle, or in this frame and the two before it. " ..
        "Fails beyond a sixth of a turn.",
      arc = "On an arc about a centre that may go along a line, from seven poses: what turns in the picture, wheels that " ..
        "roll, up to one and a quarter turns. Needs displacement = window. Fails where circles are seen aslant.",
    } },

  directions = param.choice { "one", "two", default = "one", doc = "along how many directions taps are taken" },
}
