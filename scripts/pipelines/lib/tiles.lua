-- SPDX-License-Identifier: MIT
-- Displacements per tile.
local neighbour_max = require "passes.tile.neighbour_max"
local tile_max      = require "passes.tile.tile_max"
local tile_motions  = require "passes.mask.tile_motions"

local tiles = {}

-- `layer` has velocity and may have valid. Options: `extra`, a second layer united with it; `motions`, to look for a
-- second displacement among; `prefix`, to tell the nodes of several uses apart. Yields dominant and second.
function tiles.dominant(p, layer, given)
  given = given or {}
  local prefix, extra = given.prefix or "", given.extra or {}
  local longest = tile_max {
    velocity = layer.velocity, valid = layer.valid, extra_velocity = extra.velocity, extra_valid = extra.valid,
    tile = p.tile, limit = p.limit, as = prefix .. "tile_max",
  }.longest
  return neighbour_max {
    longest = longest, motions = given.motions, tile = p.tile, limit = p.limit, rule = p.tile_rule,
    as = prefix .. "neighbour_max",
  }
end

-- Two displacements that stand for all in each tile of what raster saw; made once.
function tiles.motions(p, seen)
  seen.motions = seen.motions or tile_motions { velocity = seen.velocity, tile = p.tile, limit = p.limit }.motions
  return seen.motions
end

return tiles
