-- SPDX-License-Identifier: MIT
-- Layered composite without the second displacement per tile.
local pipeline = require "strobe.pipeline"
local layered  = require "passes.layered.layered_composite"
local reveal   = require "passes.hybrid.ray_reveal"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Layered composite with candidates from the dominant displacement and the taps only",
  params = { options.tiles(20), search_taps = layered.params.search_taps },
  build = function(p)
    local seen = scene.raster()
    local revealed = layers.of(reveal { hit = seen.hit, mask = layers.disocclusion_mask(seen) })
    local blurred = layered {
      color = seen.color, depth = seen.depth, velocity = seen.velocity,
      dominant = tiles.dominant(p, seen, { extra = revealed }).dominant,
      revealed_color = revealed.color, revealed_depth = revealed.depth, revealed_velocity = revealed.velocity,
      revealed_valid = revealed.valid, search_taps = p.search_taps,
    }.blurred
    return scene.outputs(seen, { color = blurred })
  end,
}
