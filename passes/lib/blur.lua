-- SPDX-License-Identifier: MIT
-- Parameters that the passes of a blur share. Each parameter has one meaning in every pass. If a call of a pass does
-- not set the parameter, its value is the value of the same parameter of the pipeline.
local param = require "strobe.param"

return {
  samples = param.int { 16, min = 1, max = 1024, role = "sample_count", doc = "number of samples along the motion" },

  tile = param.int { 40, min = 1, max = 1024, unit = "px", role = "tile",
    doc = "side of a tile, a square of pixels with one dominant displacement: the longest displacement that can bring a " ..
          "surface there" },

  cell_side = param.int { 10, min = 1, max = 1024, unit = "px",
    doc = "side of a cell, a square of pixels that passes skip if the bounds of its displacements show that the cell needs " ..
          "no work" },

  limit = param.float { "auto", min = 0, max = 10, auto = true, unit = "image widths", role = "reach",
    doc = "longest displacement that filters handle; longer displacements are shortened and counted. With `auto` no " ..
          "displacement is shortened: filters search as far as the longest displacement of the image" },

  depth_extent = param.float { 0.01, min = 1e-6, max = 1, role = "depth_tolerance",
    doc = "depth difference, as a fraction of the farther depth, that makes a surface count as fully in front of another " ..
          "one; smaller differences count in part" },

  trajectory = param.choice { "line", "quadratic", "arc", default = "line",
    doc = "shape of a surface point's screen path over the exposure; with displacement = extrapolated, the path is " ..
      "fitted to earlier frames",
    values = {
      line = "Straight line at constant speed. Fails for rotation: wheels blur in straight lines.",
      quadratic = "Parabola through the positions at shutter open, in the middle and at shutter close; with displacement = " ..
        "extrapolated, through the positions in this frame and the two frames before it. Fails for rotations beyond a " ..
        "sixth of a turn.",
      arc = "Arc about a centre that may move along a line, fitted to seven poses. Covers rotation in the image plane and " ..
        "rolling wheels, up to one and a quarter turns. Needs displacement = window. Fails for circles seen obliquely.",
    } },

  directions = param.choice { "one", "two", default = "one", doc = "number of directions in the image along which a filter " ..
      "takes taps" },
}
