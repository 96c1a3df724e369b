-- SPDX-License-Identifier: MIT
-- A loop over the exposure: the scene is drawn and shaded at each time, and the images are averaged. With many times, the mean
-- is ground truth without antialiasing.
local pipeline   = require "strobe.pipeline"
local blur       = require "passes.lib.blur"
local visibility = require "passes.gbuffer.visibility"
local shade      = require "passes.gbuffer.shade"
local time_mean  = require "passes.time_mean"
local scene      = require "scripts.pipelines.lib.scene"

return pipeline {
  doc    = "Mean of images drawn at each time of the exposure",
  params = { samples = blur.samples },
  build  = function(p)
    local exposed = pipeline.loop { name = "exposure", count = p.samples, times = "midpoint", body = function()
      local hit = visibility { time = "sample", as = "sample_visibility" }.hit
      local color = shade { hit = hit, time = "sample", shading = "full", as = "sample_shade" }.color
      return { mean = time_mean { color = color }.mean }
    end }
    return scene.outputs(scene.raster(), { color = exposed.mean })
  end,
}
