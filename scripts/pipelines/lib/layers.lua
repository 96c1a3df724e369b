-- SPDX-License-Identifier: MIT
-- Makes the two layers that a composite combines at each time sample: the raster layer, and the layer of the surfaces that rays
-- reveal behind it.
local pass              = require "strobe.pass"
local cull_candidates   = require "passes.layered.cull_candidates"
local gather_candidates = require "passes.layered.gather_candidates"
local relative          = require "passes.layered.disocclusion_mask"
local reveal            = require "passes.hybrid.ray_reveal"
local id_bounds         = require "passes.cell.id_bounds"
local velocity_bounds   = require "passes.cell.velocity_bounds"
local classify_cells    = require "passes.cell.classify_cells"
local paths             = require "scripts.pipelines.lib.paths"
local scene             = require "scripts.pipelines.lib.scene"
local tiles             = require "scripts.pipelines.lib.tiles"

local layers = {}

-- Least and greatest velocity in each cell of a layer (cell: a small square of pixels). `name`: name of the node.
local function bounds_of(layer, name)
  return velocity_bounds {
    velocity = layer.velocity, velocity_post = layer.velocity_post, curve = layer.curve, valid = layer.valid,
    runs = not layer.valid and "moving_rect" or nil, as = name,
  }.bounds
end

-- Mask of the pixels where background is disoccluded within the exposure, because a silhouette moves relative to the
-- background.
function layers.disocclusion_mask(raster)
  local tile = tiles.velocities(raster)
  local max_displacement = tile.max_displacement
  local near = gather_candidates {
    velocities = tile.velocities, farthest = tile.farthest, max_displacement = max_displacement,
  }
  local bounds = velocity_bounds { velocity = raster.velocity, runs = "moving_rect", as = "mask_bounds" }.bounds
  if not (raster.curve or raster.velocity_post) then raster.bounds = bounds end
  local ids = id_bounds { id = raster.id, as = "mask_ids" }.ids
  local culled = cull_candidates {
    bounds = bounds, ids = ids, max_displacement = max_displacement,
    candidates_0 = near.candidates_0, candidates_1 = near.candidates_1,
    candidates_2 = near.candidates_2, candidates_3 = near.candidates_3,
  }
  return relative {
    depth = raster.depth, id = raster.id, velocity = raster.velocity, as = "mask", bounds = bounds, ids = ids,
    max_displacement = max_displacement, farthest_around = near.farthest_around, culled_0 = culled.culled_0,
    culled_1 = culled.culled_1,
    culled_2 = culled.culled_2, culled_3 = culled.culled_3,
  }.mask
end

-- Traces a ray past the foreground in each masked pixel; returns the outputs of the pass ray_reveal. `runs`: "moving_rect" if
-- the mask is 0 outside of the rectangle that contains all motion, otherwise nil.
function layers.revealed(raster, mask, runs)
  return reveal { hit = raster.hit, mask = mask, runs = runs }
end

-- Returns the revealed layer. `found`: outputs of the pass ray_reveal.
function layers.of(found)
  return scene.layer {
    color = found.color, depth = found.depth, id = found.id, velocity = found.velocity, valid = found.valid, hit = found.found,
  }
end

-- Returns the outputs of the pass classify_cells, which marks the cells that moving surfaces reach. The composite copies the
-- pixels of all other cells.
local function moving_cells(raster, revealed, images)
  -- The velocity bounds made for the disocclusion mask are valid only for straight paths with one segment.
  local is_simple = raster.bounds and not (raster.curve or raster.velocity_post)
  local bounds = is_simple and raster.bounds or bounds_of(raster, "raster_bounds")
  return classify_cells {
    background_bounds = bounds_of(revealed, "revealed_bounds"), bounds = bounds,
    max_displacement = images.max_displacement, max_displacement_post = images.max_displacement_post,
    revealed_max_displacement = images.revealed_max_displacement,
    revealed_max_displacement_post = images.revealed_max_displacement_post,
  }
end

local function put(images, prefix, layer)
  for name, image in pairs(layer) do images[prefix .. name] = image end
end

-- Adds the curved paths of surface points to both layers, unless paths are straight lines. The raster layer is left out
-- if curves are extrapolated, because layers.both has already added the curve of the raster layer.
function layers.add_curves(p, raster, revealed)
  local background = { "revealed", revealed }
  paths.add_curves(p, paths.are_extrapolated(p) and { background } or { { "raster", raster }, background })
end

-- Returns a table with these fields:
--   whole             the raster layer, with one displacement for the whole exposure
--   mask              the disocclusion mask
--   found             the outputs of the pass ray_reveal
--   raster, revealed  both layers for a composite; with range = split, each layer has one velocity before the raster
--                     time and one after it
function layers.both(p)
  local whole = scene.raster()
  if paths.are_extrapolated(p) then paths.add_curves(p, { { "raster", whole } }) end
  local raster = paths.split(p, whole, "segments")
  local mask = paths.mask(p, raster, function(_, layer) return layers.disocclusion_mask(layer) end)
  local found = layers.revealed(whole, mask, "moving_rect")
  local revealed = paths.split(p, layers.of(found), "revealed_segments")
  layers.add_curves(p, raster, revealed)
  return { whole = whole, mask = mask, found = found, raster = raster, revealed = revealed }
end

-- Returns the outputs of a pipeline with the picture `color`. `both`: result of layers.both.
function layers.outputs(p, both, color)
  local found = both.found
  return scene.outputs(both.whole, {
    color = color, mask = both.mask, revealed = found.color, revealed_depth = found.depth,
    revealed_velocity = paths.are_extrapolated(p) and both.revealed.velocity or found.velocity,
    revealed_id = found.id, revealed_valid = found.valid,
  })
end

-- Returns the inputs of the pass `composite`: the images of the raster layer, the images of the revealed layer with the prefix
-- "revealed_", and displacements per tile. `apart`: true if each layer has its own displacements per tile, nil if both layers
-- share them.
function layers.images(p, raster, revealed, composite, apart)
  paths.require_segments(raster, composite, "the composite")
  local images = {}
  put(images, "", raster)
  put(images, "revealed_", revealed)
  local second = pass.reads(composite, "second")
  put(images, "", tiles.dominant(p, raster, { extra = not apart and revealed or nil, second = second,
                                              prefix = apart and "raster_" or "" }))
  if apart and pass.reads(composite, "revealed_dominant") then
    local around = tiles.dominant(p, revealed, { prefix = "revealed_" })
    images.revealed_dominant, images.revealed_dominant_post = around.dominant, around.dominant_post
    images.revealed_max_displacement = around.max_displacement
    images.revealed_max_displacement_post = around.max_displacement_post
  end
  if pass.reads(composite, "moved") then
    local cells = moving_cells(raster, revealed, images)
    images.moved, images.background = cells.moved, cells.background
  end
  return images
end

return layers
