-- SPDX-License-Identifier: MIT
-- Rival of the pipeline `adaptive` without a prediction: rays at all time samples of all pixels that motion may reach. A hit
-- takes its colour from the raster image if the raster image shows its surface.
local pipeline = require "strobe.pipeline"
local constant       = require "passes.mask.constant"
local adaptive_times = require "passes.time.adaptive_times"
local options = require "scripts.pipelines.lib.options"
local scene   = require "scripts.pipelines.lib.scene"

-- Largest motion between two rays of the first set, image widths. The value is so small that a surface that moves by 1 px
-- gets a ray at every time sample.
local pace = 1e-6

-- Error tolerance for one sample, linear radiance. Raster texels are blended if they differ by at most sqrt(12)/4 times this
-- value. A larger value smooths textures, a smaller value traces more shadow rays (tried: 0.01, 0.04, 0.16, no limit).
local tolerance = 0.16

return pipeline {
  doc = "Rays at all time samples of all pixels that motion may reach, with the colours of the raster image",
  params = { options.picture },
  build = function(p)
    local raster = scene.raster()
    local none = constant { everywhere = false, as = "none" }.mask
    local one_px = constant { everywhere = true, as = "one_px" }.mask
    local traced = pipeline.loop { name = "times", count = 1, times = "midpoint", slices = p.samples, body = function()
      return { picture = adaptive_times {
        color = raster.color, depth = raster.depth, id = raster.id, hit = raster.hit, velocity = raster.velocity,
        certain = none, longest = one_px, pace = pace, allowance = tolerance / p.samples(), hit_color = "blended",
        time = "sample",
      }.picture }
    end }
    return scene.outputs(raster, { color = traced.picture })
  end,
}
