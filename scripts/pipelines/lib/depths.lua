-- SPDX-License-Identifier: MIT
-- The times of the depths that filters compare.
local pipeline     = require "strobe.pipeline"
local depth_change = require "passes.scene.depth_change"

local depths = {}

depths.param = pipeline.choice { "capture", "tap", default = "capture",
  doc = "at which time depths are compared, that tell which of two surfaces is in front",
  values = {
    capture = "At the capture, as published. Fails where that changes within the exposure: what comes nearer is behind for " ..
              "all of it, a road that goes by under a car is in front of what is as far away as it was.",
    tap = "At the time that a tap stands for: to each depth comes its own change until then, from true poses. Costs two " ..
          "numbers a pixel. Fails as the filter does otherwise: what was hidden at the capture is not there.",
  } }

-- By how much the depths of a layer (a plain table: depth, id or hit, of an end of the exposure its time) change; `name` is
-- that of the layer. Nothing where the depths of the capture are compared.
function depths.change(p, name, layer)
  if p.depths() == "capture" then return nil end
  return depth_change {
    depth = layer.depth, id = layer.id, hit = layer.hit, time = layer.time, as = name .. "_depth_change",
  }.change
end

-- Gives it to each of the layers, { name, layer }.
function depths.add(p, layers)
  for _, given in ipairs(layers) do given[2].depth_change = depths.change(p, given[1], given[2]) end
end

return depths
