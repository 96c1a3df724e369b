-- SPDX-License-Identifier: MIT
-- What every pipeline starts from: what the pixels see at the capture, and its colour.
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

-- The colour of what the pixels see, shaded at the capture, where both ways of shading are the same; which shadow rays that
-- took none. `prefix` stands before the names of its nodes, nothing by default.
function scene.shaded(hit, prefix)
  prefix = prefix or ""
  local sure = shadow_shafts { hit = hit, as = prefix .. "shadow_shafts" }.sure
  return shade { hit = hit, sure = sure, shading = "frozen", as = prefix .. "shade" }.color, sure
end

-- depth, normal, id, velocity, color, sure and hit of what raster sees, or what another pass finds visible. Without the
-- parameters of a blur (options.blur) the displacement is that of the window, and all is kept as it was computed.
function scene.captured(visible)
  local hit = (visible or visibility) {}.hit
  local g = gbuffer { hit = hit }
  local color, sure = scene.shaded(hit)
  return scene.layer {
    hit = hit, depth = g.depth, normal = g.normal, id = g.id, velocity = g.velocity, color = color, sure = sure,
  }
end

-- The outputs every pipeline has, and those given. Depth and velocity are what filters read, after whatever formats did
-- to them.
function scene.outputs(seen, more)
  local outputs = { depth = seen.depth, normal = seen.normal, velocity = seen.velocity, id = seen.id }
  for name, value in pairs(more) do outputs[name] = value end
  return outputs
end

return scene
