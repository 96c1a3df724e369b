-- SPDX-License-Identifier: MIT
-- The mean of all frames so far: an image kept from frame to frame.
local pipeline = require "strobe.pipeline"
local scene    = require "scripts.pipelines.lib.scene"
local mean     = require "passes.test.running_mean"

return pipeline {
  doc = "mean of the frames so far",
  params = { weight = pipeline.float { 1, min = 0, max = 10, doc = "of every frame" } },
  build = function(p)
    local seen = scene.raster()
    local result = mean { color = seen.color, weight = p.weight, as = "mean" }
    return scene.outputs(seen, { color = result.color, sum = result.sum })
  end,
}
