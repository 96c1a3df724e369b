-- SPDX-License-Identifier: MIT
-- Bounds of what a layer does not say truly where it is: the description of a pass.
local blur = require "passes.lib.blur"

-- `others`: are bounds of another layer joined with them?
return function(name, others)
  local joined = { doc = "of another layer, to be joined with them" }
  local none = others and { bounds = "others_bounds", bends = "others_bends" } or { bounds = 0, bends = 0 }
  return {
    name   = name,
    shader = "tile/bent_bounds",
    doc    = "The least and the greatest displacement and bend of what counts in each cell, component by component",
    fails  = "Never. Two motions far apart leave much between their bounds that nothing in the cell has.",
    size   = { of = "velocity", divide = "cell_side" },
    reads  = {
      velocity = { doc = "px over the exposure" },
      bend     = { doc = "how far paths are from straight lines, px in the middle of the exposure" },
      valid    = { doc = "above 1/2 where they count" },
      others_bounds = others and joined or nil, others_bends = others and joined or nil,
    },
    writes = {
      bounds = { format = "rgba32f", doc = "least x and y, greatest x and y, px over the exposure; 0 where nothing counts" },
      bends  = { format = "rgba32f", doc = "the same of the bends" },
    },
    without = { valid = none, reached = none },
    params = {
      cell_side = blur.cell_side,
      limit     = blur.limit,
    },
  }
end
