-- SPDX-License-Identifier: MIT
-- The motion blur of the Bevy engine (2024), for any anchor.
local pipeline = require "strobe.pipeline"
local filter   = require "passes.filter.bevy"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Bevy engine: blur of each pixel along its own displacement, without tiles; no surface blurs beyond its silhouette",
  params = options.of_picture { copy_below = filter.params.copy_below },
  build = function()
    local seen = scene.captured()
    return scene.outputs(seen, {
      color = filter { color = seen.color, depth = seen.depth, velocity = seen.velocity, as = "gather" }.blurred,
    })
  end,
}
