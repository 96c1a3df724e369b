-- SPDX-License-Identifier: MIT
-- Velocity interval of each cell.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "motion_bounds",
  shader = "tile/motion_bounds",
  doc    = "Least and greatest displacement of each cell, component by component",
  fails  = "Never. Two motions far apart leave much between their bounds that nothing in the cell has.",
  size   = { of = "velocity", divide = "cell_side" },
  reads  = {
    velocity       = { doc = "px over the exposure" },
    after_velocity = { optional = true, doc = "px over the exposure, at times after the capture" },
    curve          = { optional = true, needs = "curve", doc = "of their paths, px; absent: lines" },
    valid          = { optional = true, doc = "above 1/2 where they count; absent: everywhere" },
  },
  writes = { bounds = { format = "rgba32f",
    doc = "least x and y, greatest x and y, px over the exposure; least above greatest where nothing counts" } },
  without = { reached = { bounds = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    trajectory = blur.trajectory { wired = true },
    all_count = pass.bool { false, wired = true, role = "within_reach",
      doc = "`valid` is absent, so that cells at rest lie between zeros" },
  },
}
