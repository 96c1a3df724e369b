-- SPDX-License-Identifier: MIT
-- Between which displacements all of a cell lie: the description of a pass.
local blur = require "passes.lib.blur"
local param = require "strobe.param"

-- `joined`: of what is valid alone, with the bounds of another layer; else of a layer that may be everywhere.
return function(name, joined)
  return {
    name   = name,
    shader = "tile/motion_bounds",
    doc    = "The least and the greatest displacement of each cell, component by component" ..
             (joined and ", with another layer's" or ""),
    fails  = "Never. Two motions far apart leave much between their bounds that nothing in the cell has.",
    size   = { of = "velocity", divide = "cell_side" },
    reads  = {
      velocity       = { doc = "px over the exposure" },
      after_velocity = { optional = true, doc = "px over the exposure, at times after the capture" },
      curve          = { optional = true, needs = "curve", doc = "of their paths, px; absent: lines" },
      others         = joined and { doc = "bounds of another layer, to be joined with them" } or nil,
      valid          = { optional = not joined or nil,
        doc = "above 1/2 where they count" .. (joined and "" or "; absent: everywhere") },
    },
    writes = { bounds = { format = "rgba32f",
      doc = "least x and y, greatest x and y, px over the exposure; least above greatest where nothing counts" } },
    without = joined and { valid = { bounds = "others" } } or { reached = { bounds = 0 } },
    params = {
      cell_side = blur.cell_side,
      limit     = blur.limit,
      trajectory = blur.trajectory { wired = true },
      all_count = not joined and param.bool { false, wired = true, role = "within_reach",
        doc = "`valid` is absent, so that cells at rest lie between zeros" } or nil,
    },
  }
end
