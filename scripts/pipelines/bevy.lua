-- SPDX-License-Identifier: MIT
-- The motion blur of the Bevy engine (2024), for any anchor (position of the exposure relative to the raster time).
local pipeline = require "strobe.pipeline"
local filter   = require "passes.filter.bevy"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Bevy engine: each pixel is blurred along its own displacement, so no surface is blurred beyond its silhouette",
  params = { options.picture, copy_below = filter.params.copy_below },
  build = function()
    local raster = scene.raster()
    return scene.outputs(raster, {
      color = filter { color = raster.color, depth = raster.depth, velocity = raster.velocity, as = "gather" }.blurred,
    })
  end,
}
