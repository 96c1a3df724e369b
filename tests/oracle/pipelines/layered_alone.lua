-- SPDX-License-Identifier: MIT
-- The layered composite without the second displacement per tile: what the taps alone find.
local pipeline = require "strobe.pipeline"
local layered  = require "passes.layered.layered_composite"
local reveal   = require "passes.hybrid.ray_reveal"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

local params = {
    options.blur(20, 0.1),
  harvest = pipeline.bool { true, doc = "look for displacements at the taps" },
}
params.depth_extent = nil -- depths are compared as they are

return pipeline {
  doc = "Layered composite with candidates from the dominant displacement and the taps only",
  params = params,
  build = function(p)
    local seen = scene.raster()
    local revealed = reveal { hit = seen.hit, mask = layers.disocclusion_mask(seen) }
    local blurred = layered {
      color = seen.color, depth = seen.depth, velocity = seen.velocity,
      dominant = tiles.dominant(p, seen, { extra = revealed }).dominant,
      revealed_color = revealed.color, revealed_depth = revealed.depth, revealed_velocity = revealed.velocity,
      revealed_valid = revealed.valid, harvest = p.harvest,
    }.blurred
    return scene.outputs(seen, { color = blurred })
  end,
}
