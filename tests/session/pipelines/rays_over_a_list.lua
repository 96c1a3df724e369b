-- SPDX-License-Identifier: MIT
-- Rays for a list of the moving pixels.
local pipeline = require "strobe.pipeline"
local moving   = require "passes.mask.moving"
local traced   = require "passes.traced"
local compact    = require "scripts.pipelines.lib.compact"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Distances by rays at the moving pixels",
  params = options.blur(8),
  build = function(p)
    local seen = scene.raster()
    local mask = moving { velocity = seen.velocity, dominant = tiles.dominant(p, seen).dominant }.mask
    local distance = traced { listed = compact.pixels(mask, "moving") }.distance
    return scene.outputs(seen, { color = seen.color, distance = distance })
  end,
}
