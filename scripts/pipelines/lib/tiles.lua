-- SPDX-License-Identifier: MIT
-- Displacements per tile (a tile is a square of pixels): dominant, shortest and candidate displacements, and the variance of
-- their directions.
local pipeline      = require "strobe.pipeline"
local neighbour_max   = require "passes.tile.neighbour_max"
local neighbour_min   = require "passes.tile.neighbour_min"
local tile_max        = require "passes.tile.tile_max"
local tile_min        = require "passes.tile.tile_min"
local tile_velocities = require "passes.layered.tile_velocities"
local variance        = require "passes.tile.direction_variance"
local paths           = require "scripts.pipelines.lib.paths"

local tiles = {}

local around_tiles = pipeline.record("the result of tiles.dominant",
                                     { "second", "dominant_curve", "dominant_place", "dominant_post", "second_post",
                                       "max_displacement_post" })

local function in_one_part(p, layer, given)
  local prefix, extra = given.prefix or "", given.extra or {}
  local extra_curve = extra.curve
  local tile = tile_max {
    velocity = layer.velocity, valid = layer.valid, extra_velocity = extra.velocity, extra_valid = extra.valid,
    curve = layer.curve, extra_curve = extra_curve, as = prefix .. "tile_max",
  }
  local longest, is_curved = tile.longest, layer.curve or extra_curve
  local curve = is_curved and tile.curve_of_it or nil
  local velocities = given.second and tiles.velocities(layer).velocities or nil
  local around = neighbour_max {
    longest = longest, curve = curve, place = is_curved and tile.place_of_it or nil, velocities = velocities,
    max_displacement = tile.max_displacement, rule = p.tile_rule, as = prefix .. "neighbour_max",
  }
  return around_tiles {
    dominant = around.dominant, second = around.second, longest = longest,
    max_displacement = tile.max_displacement,
    dominant_curve = curve and around.dominant_curve or nil, dominant_place = curve and around.dominant_place or nil,
  }
end

-- Finds the dominant displacement of each tile of `layer`: the longest displacement that can reach the tile within the
-- exposure. `layer` has velocity and optionally valid. Options in `given`:
--   extra   a second layer; its displacements are included
--   second  true: also find the displacement around each tile that differs most from the dominant one
--   prefix  start of the names of the nodes
-- Returns these images:
--   dominant, second       dominant and second displacement of each tile, px over the exposure
--   longest                longest displacement within each tile, px over the exposure
--   max_displacement       length of the longest displacement of the image
--   dominant_curve, dominant_place  only with curved paths: curve and position of the texel with the dominant displacement
--   dominant_post, second_post, max_displacement_post  only if the layer has two segments (paths.split): the values after the
--                                                      raster time
function tiles.dominant(p, layer, given)
  given = given or {}
  local result = in_one_part(p, layer, given)
  if not layer.velocity_post then return result end
  local extra = given.extra and paths.post(given.extra)
  local given_post = { extra = extra, second = given.second, prefix = given.prefix }
  local post = pipeline.prefixed("post_", function()
    return in_one_part(p, paths.post(layer), given_post)
  end)
  result.dominant_post, result.second_post = post.dominant, post.second
  result.max_displacement_post = post.max_displacement
  return result
end

-- Length of the shortest displacement in and around each tile, px over the exposure. `around`: result of tiles.dominant.
function tiles.slowest(layer, around)
  local shortest = tile_min { velocity = layer.velocity, valid = layer.valid }.shortest
  return neighbour_min { shortest = shortest, max_displacement = around.max_displacement }.slowest
end

-- Variance of the motion directions around each tile, 0 (all parallel) to 1. `around`: result of tiles.dominant.
function tiles.variance(around)
  return variance { longest = around.longest, dominant = around.dominant }.variance
end

-- Returns the outputs of the pass tile_velocities: the longest displacement of each tile, the displacement that differs most
-- from the longest, and the depth of the farthest moving surface in the tile. The pass runs once per layer; later calls return
-- the stored outputs.
function tiles.velocities(raster)
  raster.velocities = raster.velocities or tile_velocities { velocity = raster.velocity, depth = raster.depth }
  return raster.velocities
end

return tiles
