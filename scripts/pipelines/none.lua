-- SPDX-License-Identifier: MIT
-- No blur: the raster image.
local pipeline = require "strobe.pipeline"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Raster image without blur",
  kind = "sharp",
  breaks = { uniform = "it does not blur" },
  build = function()
    local seen = scene.captured()
    return scene.outputs(seen, { color = seen.color })
  end,
}
