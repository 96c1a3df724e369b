-- SPDX-License-Identifier: MIT
-- Displacements per tile.
local pipeline      = require "strobe.pipeline"
local longest_motion = require "passes.tile.longest_motion"
local neighbour_max = require "passes.tile.neighbour_max"
local neighbour_min = require "passes.tile.neighbour_min"
local tile_max      = require "passes.tile.tile_max"
local tile_min      = require "passes.tile.tile_min"
local tile_motions  = require "passes.mask.tile_motions"
local variance      = require "passes.tile.variance"
local ranges        = require "scripts.pipelines.lib.ranges"

local tiles = {}

local around_tiles = pipeline.record("the result of tiles.dominant",
                                     { "second", "dominant_curve", "dominant_place", "after_dominant", "after_second" })

local function in_one_part(p, layer, given)
  local prefix, extra = given.prefix or "", given.extra or {}
  local extra_curve = pipeline.optional(extra, "curve")
  local tile = tile_max {
    velocity = layer.velocity, valid = layer.valid, extra_velocity = extra.velocity, extra_valid = extra.valid,
    curve = layer.curve, extra_curve = extra_curve, as = prefix .. "tile_max",
  }
  local longest, is_curved = tile.longest, layer.curve or extra_curve
  local curve = is_curved and tile.curve_of_it or nil
  local motions = given.second and tiles.motions(layer) or nil
  local reach = longest_motion { longest = longest, curve = curve, as = prefix .. "longest_motion" }.reach
  local around = neighbour_max {
    longest = longest, curve = curve, place = is_curved and tile.place_of_it or nil, motions = motions, reach = reach,
    rule = p.tile_rule, as = prefix .. "neighbour_max",
  }
  return around_tiles {
    dominant = around.dominant, second = around.second, longest = longest, reach = reach,
    dominant_curve = curve and around.dominant_curve or nil, dominant_place = curve and around.dominant_place or nil,
  }
end

-- Displacements that dominate each tile of `layer` (velocity, optionally valid). Options: `extra`, a second layer to include;
-- `second` = true, to find a second displacement too; `prefix`, start of the names of its nodes.
-- Returns dominant, second, longest and reach; for curved paths dominant_curve and dominant_place; for a layer with two
-- segments (ranges.divided) after_dominant and after_second.
function tiles.dominant(p, layer, given)
  given = given or {}
  local result = in_one_part(p, layer, given)
  if not layer.after_velocity then return result end
  local extra = given.extra and ranges.after(given.extra)
  local given_after = { extra = extra, second = given.second, prefix = given.prefix }
  local after = pipeline.prefixed("after_", function()
    return in_one_part(p, ranges.after(layer), given_after)
  end)
  result.after_dominant, result.after_second = after.dominant, after.second
  return result
end

-- Length of the shortest displacement around each tile, px; `around` is a result of tiles.dominant.
function tiles.slowest(layer, around)
  local shortest = tile_min { velocity = layer.velocity, valid = layer.valid }.shortest
  return neighbour_min { shortest = shortest, reach = around.reach }.slowest
end

-- Variance of the directions around each tile; `around` is a result of tiles.dominant.
function tiles.variance(around)
  return variance { longest = around.longest, dominant = around.dominant }.variance
end

-- Two candidate displacements of each tile of a layer, and the depth of its farthest moving surface; made once per layer.
function tiles.motions(seen)
  seen.motions = seen.motions or tile_motions { velocity = seen.velocity, depth = seen.depth }
  return seen.motions.motions, seen.motions.farthest
end

return tiles
