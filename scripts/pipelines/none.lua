-- SPDX-License-Identifier: MIT
-- No blur: the raster image.
local pipeline = require "strobe.pipeline"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Raster image without blur",
  kind = "sharp",
  breaks = { uniform = "the pipeline does not blur" },
  build = function()
    local raster = scene.raster()
    return scene.outputs(raster, { color = raster.color })
  end,
}
