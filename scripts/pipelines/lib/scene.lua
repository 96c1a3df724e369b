-- SPDX-License-Identifier: MIT
-- The start of every pipeline: the visible surfaces at the raster time, and their colour.
local visibility = require "passes.gbuffer.visibility"
local pipeline   = require "strobe.pipeline"
local gbuffer    = require "passes.gbuffer.gbuffer"
local shade      = require "passes.gbuffer.shade"
local tile_light_visibility = require "passes.tile.tile_light_visibility"

local scene = {}

-- A layer: images of one surface per pixel. These fields may be absent; lib/ranges and lib/curves add some.
scene.layer = pipeline.record("a layer", {
  "valid", "normal", "hit", "light_visibility", "velocities", "bounds", "curve", "path_deviation", "nonlinear",
  "velocity_post", "whole_velocity", "post",
})

-- The colour of the visible surfaces, shaded at the raster time (both values of `shading` agree there), and `light_visibility`:
-- lights with known visibility per tile, which need no shadow rays. `prefix`: start of the names of its nodes; nil: none.
function scene.shaded(hit, prefix)
  prefix = prefix or ""
  local light_visibility = tile_light_visibility { hit = hit, as = prefix .. "tile_light_visibility" }.light_visibility
  local color = shade { hit = hit, light_visibility = light_visibility, shading = "frozen", as = prefix .. "shade" }.color
  return color, light_visibility
end

-- The raster layer: depth, normal, id, velocity, color, sure and hit of the visible surfaces. `visible` replaces the raster
-- pass. Without the parameters of a blur (options.blur), displacement = window and images are not quantised.
function scene.raster(visible)
  local hit = (visible or visibility) {}.hit
  local g = gbuffer { hit = hit }
  local color, light_visibility = scene.shaded(hit)
  return scene.layer {
    hit = hit, depth = g.depth, normal = g.normal, id = g.id, velocity = g.velocity, color = color,
    light_visibility = light_visibility,
  }
end

-- The outputs that every pipeline has, and `more`. Depth and velocity are the quantised images that filters read.
function scene.outputs(raster, more)
  local outputs = { depth = raster.depth, normal = raster.normal, velocity = raster.velocity, id = raster.id }
  for name, value in pairs(more) do outputs[name] = value end
  return outputs
end

return scene
