-- SPDX-License-Identifier: MIT
-- Mask `moving` from invalid displacements; the tiles hold valid ones.
local pipeline = require "strobe.pipeline"
local damage   = require "passes.damage"
local moving   = require "passes.mask.moving"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Moving pixels, from displacements that are partly invalid",
  params = options.blur(8, 0.1),
  build = function(p)
    local seen = scene.raster()
    local velocity = damage { velocity = seen.velocity }.velocity
    local mask = moving { velocity = velocity, dominant = tiles.dominant(p, seen).dominant }.mask
    return scene.outputs(seen, { color = seen.color, mask = mask })
  end,
}
