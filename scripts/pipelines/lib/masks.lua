-- SPDX-License-Identifier: MIT
-- Which pixels to reveal something behind. Each is a function of the pipeline's parameters and what raster saw.
local candidate        = require "passes.mask.candidate"
local constant         = require "passes.mask.constant"
local crossing_motions = require "passes.mask.crossing_motions"
local moving           = require "passes.mask.moving"
local near_motions     = require "passes.mask.near_motions"
local range_check      = require "passes.mask.range_check"
local relative         = require "passes.mask.relative"
local longest_motion   = require "passes.tile.longest_motion"
local id_bounds        = require "passes.tile.id_bounds"
local motion_bounds    = require "passes.tile.motion_bounds"
local edges            = require "scripts.pipelines.lib.edges"
local tiles            = require "scripts.pipelines.lib.tiles"

local masks = {}

masks["none"] = function() return constant { as = "mask" }.mask end

-- Tan, Cui and Bhojan 2020: displaced position, edges there, everything from which such an edge is in range.
masks["seed"] = function(p, seen)
  local where = candidate {
    depth = seen.depth, id = seen.id, velocity = seen.velocity, taps = p.mask_taps,
  }.candidate
  return range_check {
    edge = edges.detected(p.edge(), seen, where), id = seen.id, velocity = seen.velocity,
    own_edge = p.own_edge, as = "mask",
  }.mask
end

-- Motion relative to the background decides.
masks["relative"] = function(_, seen)
  local motions, farthest = tiles.motions(seen)
  local reach = longest_motion { longest = motions, as = "mask_longest_motion" }.reach
  local near = near_motions { motions = motions, farthest = farthest, reach = reach }
  local bounds = motion_bounds { velocity = seen.velocity, all_count = true, as = "mask_bounds" }.bounds
  local ids = id_bounds { id = seen.id, as = "mask_ids" }.ids
  local crossing = crossing_motions {
    bounds = bounds, ids = ids, reach = reach,
    motions_0 = near.motions_0, motions_1 = near.motions_1, motions_2 = near.motions_2, motions_3 = near.motions_3,
  }
  return relative {
    depth = seen.depth, id = seen.id, velocity = seen.velocity, as = "mask", bounds = bounds, ids = ids, reach = reach,
    farthest_around = near.farthest_around, crossing_0 = crossing.crossing_0, crossing_1 = crossing.crossing_1,
    crossing_2 = crossing.crossing_2, crossing_3 = crossing.crossing_3,
  }.mask
end

-- All but what is still.
masks["moving"] = function(p, seen)
  local dominant = tiles.dominant(p, seen, { prefix = "mask_" }).dominant
  return moving { velocity = seen.velocity, dominant = dominant, as = "mask" }.mask
end

return masks
