-- SPDX-License-Identifier: MIT
-- The start of every pipeline: the visible surfaces at the raster time, and their colour.
local visibility = require "passes.scene.visibility"
local pipeline   = require "strobe.pipeline"
local gbuffer    = require "passes.scene.gbuffer"
local shade      = require "passes.scene.shade"
local shadow_shafts = require "passes.tile.shadow_shafts"

local scene = {}

-- A layer: images of one surface per pixel. These fields may be absent; lib/ranges and lib/curves add some.
scene.layer = pipeline.record("a layer", {
  "valid", "normal", "hit", "sure", "motions", "bounds", "curve", "bend", "bent",
  "after_velocity", "whole_velocity", "after",
})

-- The colour of the visible surfaces, shaded at the raster time (both values of `shading` agree there), and `sure`: lights with
-- known visibility per tile, which need no shadow rays. `prefix`: start of the names of its nodes; nil: none.
function scene.shaded(hit, prefix)
  prefix = prefix or ""
  local sure = shadow_shafts { hit = hit, as = prefix .. "shadow_shafts" }.sure
  return shade { hit = hit, sure = sure, shading = "frozen", as = prefix .. "shade" }.color, sure
end

-- The raster layer: depth, normal, id, velocity, color, sure and hit of the visible surfaces. `visible` replaces the raster
-- pass. Without the parameters of a blur (options.blur), displacement = window and images are not quantised.
function scene.captured(visible)
  local hit = (visible or visibility) {}.hit
  local g = gbuffer { hit = hit }
  local color, sure = scene.shaded(hit)
  return scene.layer {
    hit = hit, depth = g.depth, normal = g.normal, id = g.id, velocity = g.velocity, color = color, sure = sure,
  }
end

-- The outputs that every pipeline has, and `more`. Depth and velocity are the quantised images that filters read.
function scene.outputs(seen, more)
  local outputs = { depth = seen.depth, normal = seen.normal, velocity = seen.velocity, id = seen.id }
  for name, value in pairs(more) do outputs[name] = value end
  return outputs
end

return scene
