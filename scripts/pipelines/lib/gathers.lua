-- SPDX-License-Identifier: MIT
-- Blur of one layer.
local ranges = require "scripts.pipelines.lib.ranges"

local gathers = {}

-- `weights` names a file of passes/gather. `layer` has color, depth, velocity and may have valid; `dominant` is what
-- tiles.dominant yields for it; `behind`, if given, is the layer revealed behind it (depth, valid).
function gathers.blurred(p, weights, layer, dominant, behind, name)
  local gather = require("passes.gather." .. weights)
  ranges.require_parts(layer, gather, "weights = " .. weights)
  local arguments = {
    color = layer.color, depth = layer.depth, velocity = layer.velocity, dominant = dominant.dominant, as = name,
    samples = p.samples, tile = p.tile, limit = p.limit, depth_extent = p.depth_extent, jitter = p.jitter,
  }
  if layer.after_velocity then
    arguments.after_velocity, arguments.after_dominant = layer.after_velocity, dominant.after_dominant
  end
  if layer.valid then arguments.valid = layer.valid end
  if behind then arguments.behind_depth, arguments.behind_valid = behind.depth, behind.valid end
  return gather(arguments).blurred
end

return gathers
