-- SPDX-License-Identifier: MIT
-- The raster layer and the layer that rays reveal behind it, for composites per time sample.
local pass             = require "strobe.pass"
local crossing_motions = require "passes.mask.crossing_motions"
local near_motions     = require "passes.mask.near_motions"
local relative         = require "passes.mask.relative"
local reveal           = require "passes.scene.reveal"
local id_bounds        = require "passes.tile.id_bounds"
local longest_motion   = require "passes.tile.longest_motion"
local motion_bounds    = require "passes.tile.motion_bounds"
local motion_reach     = require "passes.tile.motion_reach"
local curves           = require "scripts.pipelines.lib.curves"
local ranges           = require "scripts.pipelines.lib.ranges"
local scene            = require "scripts.pipelines.lib.scene"
local tiles            = require "scripts.pipelines.lib.tiles"

local layers = {}

-- Velocity interval of each cell of a layer.
local function bounds_of(layer, name)
  return motion_bounds {
    velocity = layer.velocity, after_velocity = layer.after_velocity, curve = layer.curve, valid = layer.valid,
    all_count = not layer.valid or nil, as = name,
  }.bounds
end

-- Mask of the pixels that a silhouette disoccludes by its motion relative to its background.
function layers.disocclusion_mask(raster)
  local motions, farthest = tiles.motions(raster)
  local reach = longest_motion { longest = motions, as = "mask_longest_motion" }.reach
  local near = near_motions { motions = motions, farthest = farthest, reach = reach }
  local bounds = motion_bounds { velocity = raster.velocity, all_count = true, as = "mask_bounds" }.bounds
  if not (raster.curve or raster.after_velocity) then raster.bounds = bounds end
  local ids = id_bounds { id = raster.id, as = "mask_ids" }.ids
  local crossing = crossing_motions {
    bounds = bounds, ids = ids, reach = reach,
    motions_0 = near.motions_0, motions_1 = near.motions_1, motions_2 = near.motions_2, motions_3 = near.motions_3,
  }
  return relative {
    depth = raster.depth, id = raster.id, velocity = raster.velocity, as = "mask", bounds = bounds, ids = ids, reach = reach,
    farthest_around = near.farthest_around, crossing_0 = crossing.crossing_0, crossing_1 = crossing.crossing_1,
    crossing_2 = crossing.crossing_2, crossing_3 = crossing.crossing_3,
  }.mask
end

-- Traces behind the mask; returns the ports of `reveal`. `mask_reached`: true if the mask is 0 in pixels without any motion.
function layers.revealed(raster, mask, mask_reached)
  return reveal { hit = raster.hit, mask = mask, mask_reached = mask_reached }
end

-- The revealed layer, from the ports of `reveal`.
function layers.of(found)
  return scene.layer {
    color = found.color, depth = found.depth, id = found.id, velocity = found.velocity, valid = found.valid, hit = found.found,
  }
end

-- Cells with motion; the composite copies the pixels of the other cells.
local function moving_cells(raster, revealed, images, slowest)
  -- The mask's bounds hold for straight paths with one segment.
  local is_simple = raster.bounds and not (raster.curve or raster.after_velocity)
  local bounds = is_simple and raster.bounds or bounds_of(raster, "raster_bounds")
  local reach = images.reach
  if images.after_dominant or images.revealed_dominant then
    reach = longest_motion {
      longest = images.dominant, after = images.after_dominant, revealed = images.revealed_dominant,
      revealed_after = images.revealed_after_dominant, as = "longest_of_all",
    }.reach
  end
  return motion_reach {
    behind_bounds = bounds_of(revealed, "revealed_bounds"), bounds = bounds, slowest = slowest,
    dominant = images.dominant, after_dominant = images.after_dominant,
    second = images.second, after_second = images.after_second, reach = reach,
    revealed_dominant = images.revealed_dominant, revealed_after_dominant = images.revealed_after_dominant,
  }
end

local function put(images, prefix, layer)
  for name, image in pairs(layer) do images[prefix .. name] = image end
end

-- Adds curves to both layers if paths are not straight lines.
function layers.bend(p, raster, revealed)
  local behind = { "revealed", revealed }
  curves.add(p, curves.are_foretold(p) and { behind } or { { "raster", raster }, behind })
end

-- The raster layer as captured, the disocclusion mask, the ports of `reveal` (`found`), and both layers for the composite
-- `layered`: `raster` and `revealed`.
function layers.both(p)
  local captured = scene.captured()
  if curves.are_foretold(p) then curves.add(p, { { "raster", captured } }) end
  local raster = ranges.divided(p, captured, "halves")
  local mask = ranges.mask(p, raster, function(_, layer) return layers.disocclusion_mask(layer) end)
  local found = layers.revealed(captured, mask, true)
  local revealed = ranges.divided(p, layers.of(found), "revealed_halves")
  layers.bend(p, raster, revealed)
  return { captured = captured, mask = mask, found = found, raster = raster, revealed = revealed }
end

-- The outputs of a pipeline with the layers `both`.
function layers.outputs(p, both, color)
  local found = both.found
  return scene.outputs(both.captured, {
    color = color, mask = both.mask, revealed = found.color, revealed_depth = found.depth,
    revealed_velocity = curves.are_foretold(p) and both.revealed.velocity or found.velocity,
    revealed_id = found.id, revealed_valid = found.valid,
  })
end

-- Inputs of a composite: `x` of the raster layer, `revealed_x` of the revealed layer, displacements per tile.
-- `slowest`: largest displacement of a static pixel, px; nil: 0.5. `apart`: each layer has its own displacements per tile.
function layers.images(p, raster, revealed, composite, slowest, apart)
  ranges.require_parts(raster, composite, "the composite")
  local images = {}
  put(images, "", raster)
  put(images, "revealed_", revealed)
  local second = pass.reads(composite, "second")
  put(images, "", tiles.dominant(p, raster, { extra = not apart and revealed or nil, second = second,
                                              prefix = apart and "raster_" or "" }))
  if apart and pass.reads(composite, "revealed_dominant") then
    local around = tiles.dominant(p, revealed, { prefix = "revealed_" })
    images.revealed_dominant, images.revealed_after_dominant = around.dominant, around.after_dominant
  end
  if pass.reads(composite, "moved") then
    local cells = moving_cells(raster, revealed, images, slowest)
    images.moved, images.behind, images.missed = cells.moved, cells.behind, cells.missed
  end
  return images
end

return layers
