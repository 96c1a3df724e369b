-- SPDX-License-Identifier: MIT
-- First part of every pipeline's graph: the visible surfaces at the raster time, and their colours.
local visibility = require "passes.gbuffer.visibility"
local pipeline   = require "strobe.pipeline"
local gbuffer    = require "passes.gbuffer.gbuffer"
local shade      = require "passes.gbuffer.shade"
local tile_light_visibility = require "passes.tile.tile_light_visibility"

local scene = {}

-- Makes a layer: a table of images with one surface per pixel. A layer may lack any of the fields below; lib/paths adds
-- some of these fields.
scene.layer = pipeline.record("a layer", {
  "valid", "normal", "hit", "light_visibility", "velocities", "bounds", "curve", "velocity_post", "post",
})

-- Returns the colour of the surfaces `hit`, shaded at the raster time, and `light_visibility`: for each tile, the lights that
-- are visible from all or from no points of the tile, and therefore need no shadow rays. The choice of the parameter
-- `shading` has no effect at the raster time. `prefix`: start of the names of the nodes; nil: none.
function scene.shaded(hit, prefix)
  prefix = prefix or ""
  local light_visibility = tile_light_visibility { hit = hit, as = prefix .. "tile_light_visibility" }.light_visibility
  local color = shade { hit = hit, light_visibility = light_visibility, shading = "frozen", as = prefix .. "shade" }.color
  return color, light_visibility
end

-- Returns the raster layer: hit, depth, normal, id, velocity, color and light_visibility of the visible surfaces. `visible`: a
-- pass that finds the visible surfaces; nil: the raster pass. A pipeline may lack the parameters in the table `options.picture`
-- of lib/options. It then has their defaults: velocities are computed from the poses at shutter open and shutter close, and
-- images are not quantised.
function scene.raster(visible)
  local hit = (visible or visibility) {}.hit
  local g = gbuffer { hit = hit }
  local color, light_visibility = scene.shaded(hit)
  return scene.layer {
    hit = hit, depth = g.depth, normal = g.normal, id = g.id, velocity = g.velocity, color = color,
    light_visibility = light_visibility,
  }
end

-- Returns the outputs that every pipeline has, and the outputs in the table `more`. Depth and velocity are the quantised images
-- that filters read, not the exact values.
function scene.outputs(raster, more)
  local outputs = { depth = raster.depth, normal = raster.normal, velocity = raster.velocity, id = raster.id }
  for name, value in pairs(more) do outputs[name] = value end
  return outputs
end

return scene
