-- SPDX-License-Identifier: MIT
-- Motion blur of the raster image: the pass `smear` averages colours along the displacement of each pixel.
local pipeline = require "strobe.pipeline"
local smear    = require "passes.smear"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Raster image, averaged along each pixel's own displacement",
  params = { taps = smear.params.taps },
  build = function(p)
    local seen = scene.raster()
    return scene.outputs(seen, { color = smear { color = seen.color, velocity = seen.velocity, taps = p.taps }.color })
  end,
}
